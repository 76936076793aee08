#include "kernel/hull_output.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/large_array.h"
#include "kernel/large_block.h"
#include "kernel/parallel.h"
#include "kernel/radix_sort.h"

namespace tetsculpt::hull {
namespace {

using Corners = std::array<VertexId, 4>;

/// Where corner i of a facet goes when they are put in order: bits 2 i and 2 i + 1.
using Places = std::uint8_t;

std::uint32_t place(Places places, std::uint32_t corner) { return (places >> (2 * corner)) & 3; }

/// Puts corners in ascending order, infinity last; the last two change places if that keeps the
/// orientation. A corner's place is how many are less.
Places put_in_order(const std::array<Site, 4>& corners, Corners& to) {
  const auto less = [&](std::size_t i, std::size_t j) -> std::uint32_t {
    return corners[i] < corners[j];
  };
  const std::uint32_t l10 = less(1, 0);
  const std::uint32_t l20 = less(2, 0);
  const std::uint32_t l30 = less(3, 0);
  const std::uint32_t l21 = less(2, 1);
  const std::uint32_t l31 = less(3, 1);
  const std::uint32_t l32 = less(3, 2);
  const std::uint32_t odd = l10 ^ l20 ^ l30 ^ l21 ^ l31 ^ l32;
  std::uint32_t places = 0;
  const auto put = [&](std::uint32_t i, std::uint32_t place) {
    place ^= odd & place >> 1;
    to[place] = VertexId{corners[i]};
    places |= place << (2 * i);
  };
  put(0, l10 + l20 + l30);
  put(1, 1 - l10 + l21 + l31);
  put(2, 2 - l20 - l21 + l32);
  put(3, 3 - l30 - l31 - l32);
  return static_cast<Places>(places);
}

class Output {
 public:
  Output(Facets& facets, std::size_t site_count, int threads)
      : threads_(threads), bucket_count_(2 * site_count) {
    take(facets);
    share_buckets();
  }

  LiftedHull run(const std::function<void(double)>& progress) {
    const auto told = [&](double share) {
      if (progress) progress(share);
    };
    told(0.2);
    fill_buckets();
    told(0.3);
    LiftedHull hull;
    hull.finite_count = begin_of(bucket_count_ / 2);
    hull.tets.resize(count_);
    hull.neighbors.resize(count_);
    for_each_share([&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b) write_bucket(hull, begin_of(b), end_[b]);
    });
    told(0.8);
    number_neighbors(hull.neighbors);
    told(1);
    return hull;
  }

 private:
  /// So many are sorted by counting.
  static constexpr std::uint32_t kFew = 64;
  /// What is needed so many steps later is asked for: it lies anywhere in memory.
  static constexpr std::size_t kAhead = 16;

  struct Item {
    Corners corners;
    FacetIndex facet;
    Places places;

    /// Sorts a bucket: no two tetrahedra have the same first three corners, because those around an
    /// edge, as they are oriented, lead from each third corner to one fourth.
    std::uint64_t key() const { return std::uint64_t{+corners[1]} << 32 | +corners[2]; }
  };

  /// One bucket per lowest corner; those of infinite facets come after all others.
  std::size_t bucket(const FacetLinks& facet) const {
    const auto& c = facet.corners;
    const std::size_t lowest = std::min(std::min(c[0], c[1]), std::min(c[2], c[3]));
    return facet.infinite() ? lowest + bucket_count_ / 2 : lowest;
  }
  std::uint32_t begin_of(std::size_t b) const { return b == 0 ? 0 : end_[b - 1]; }

  /// Takes the facets and counts what will be in each bucket: end_[b] is b's beginning.
  void take(Facets& facets) {
    // Each thread counts in a table of its own: a few, whatever their number, cost little memory.
    const int threads = std::min(threads_, 4);
    std::vector<LargeArray<std::uint32_t>> counts(worth_threads(facets.size(), threads));
    for (auto& count : counts) count.resize(bucket_count_, 0);
    facets_ = facets.take_links(threads, [&](std::size_t thread, const FacetLinks& facet) {
      if (facet.lives()) ++counts[thread][bucket(facet)];
    });
    end_ = std::move(counts[0]);
    for (std::size_t b = 0; b < bucket_count_; ++b) {
      std::uint32_t count = end_[b];
      for (std::size_t thread = 1; thread < counts.size(); ++thread) count += counts[thread][b];
      end_[b] = static_cast<std::uint32_t>(count_);
      count_ += count;
    }
  }

  /// Shares the buckets out among the threads, by what is in them.
  void share_buckets() {
    const std::size_t parts = worth_threads(count_, threads_);
    cuts_.assign(1, 0);
    for (std::size_t part = 1; part < parts; ++part) {
      const auto cut = std::ranges::lower_bound(end_, count_ * part / parts);
      cuts_.push_back(static_cast<std::size_t>(cut - end_.begin()));
    }
    cuts_.push_back(bucket_count_);
  }
  /// Calls work(begin, end) on each share, on a thread of its own.
  template <class Work>
  void for_each_share(Work&& work) const {
    parallel_each(cuts_.size() - 1, [&](std::size_t part) { work(cuts_[part], cuts_[part + 1]); });
  }

  /// Lists the facets by bucket and puts the ends of the buckets into end_. Each thread reads all
  /// facets for those of its share: two that fill one bucket wait for each other's cache lines, and
  /// are slower than one.
  void fill_buckets() {
    facet_at_.resize(count_);
    for_each_share([&](std::size_t begin, std::size_t end) {
      for (FacetIndex f = 0; f < facets_.capacity(); ++f) {
        if (!facets_[f].lives()) continue;
        const std::size_t b = bucket(facets_[f]);
        if (b >= begin && b < end) facet_at_[end_[b]++] = f;
      }
    });
  }

  /// Writes the tetrahedra of a bucket in their order.
  void write_bucket(LiftedHull& hull, std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t size = end - begin;
    if (size > kFew) return write_large_bucket(hull, begin, end);
    // Counts how many come before each: no branch depends on the order they are in.
    std::array<Item, kFew> items;
    std::array<std::uint64_t, kFew> keys;
    std::array<std::uint32_t, kFew> before;
    for (std::uint32_t i = 0; i < size; ++i) {
      items[i] = item(begin + i);
      keys[i] = items[i].key();
      std::uint32_t smaller = 0;
      for (std::uint32_t k = 0; k < i; ++k) {
        const bool less = keys[k] < keys[i];
        smaller += less;
        before[k] += !less;
      }
      before[i] = smaller;
    }
    for (std::uint32_t i = 0; i < size; ++i) put(items[i], hull, begin + before[i]);
  }

  void write_large_bucket(LiftedHull& hull, std::uint32_t begin, std::uint32_t end) {
    LargeArray<KeyedIndex> order(end - begin);
    for (std::uint32_t i = begin; i < end; ++i) order[i - begin] = {item(i).key(), i};
    radix_sort(order);
    for (std::uint32_t i = begin; i < end; ++i) put(item(order[i - begin].index), hull, i);
  }

  Item item(std::uint32_t i) const {
    __builtin_prefetch(&facets_[facet_at_[std::min(i + kAhead, count_ - 1)]]);
    Item item;
    item.facet = facet_at_[i];
    item.places = put_in_order(facets_[item.facet].corners, item.corners);
    return item;
  }

  /// Where it went takes the place of the facet's own corners.
  void put(const Item& item, LiftedHull& hull, std::uint32_t at) {
    hull.tets[at] = item.corners;
    FacetLinks& facet = facets_[item.facet];
    for (std::uint32_t i = 0; i < 4; ++i) {
      hull.neighbors[at][place(item.places, i)] = facet.neighbors[i];
    }
    facet.corners = {at, item.places};
  }

  /// From ridges of facets to facets of tetrahedra.
  void number_neighbors(LargeArray<std::array<FacetHandle, 4>>& neighbors) const {
    parallel_ranges(count_, threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        const auto& later = neighbors[std::min(t + kAhead, end - 1)];
        for (std::uint32_t i = 0; i < 4; ++i) {
          __builtin_prefetch(&facets_[facet_of(later[i])]);
          const Ridge r = neighbors[t][i];
          const auto [tet, places, unused, none] = facets_[facet_of(r)].corners;
          neighbors[t][i] = 4 * tet + place(static_cast<Places>(places), corner_of(r));
        }
      }
    });
  }

  int threads_;
  std::size_t bucket_count_;
  LargeBlock<FacetLinks> facets_;    ///< living and dead
  std::size_t count_ = 0;            ///< living
  LargeArray<std::uint32_t> end_;    ///< per bucket
  std::vector<std::size_t> cuts_;    ///< buckets that begin a share, and the end
  LargeArray<FacetIndex> facet_at_;  ///< per tetrahedron, in the order of buckets
};

}  // namespace

LiftedHull output(Facets& facets, std::size_t site_count, int threads,
                  const std::function<void(double)>& progress) {
  return Output(facets, site_count, threads).run(progress);
}

}  // namespace tetsculpt::hull
