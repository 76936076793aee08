#include "kernel/hull_output.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "kernel/large_array.h"
#include "kernel/large_block.h"
#include "kernel/parallel.h"

namespace tetsculpt::hull {
namespace {

using Corners = std::array<VertexId, 4>;

/// Where corner i of a facet goes when they are put in order: bits 2 i and 2 i + 1.
using Places = std::uint8_t;

std::uint32_t place(Places places, std::uint32_t corner) { return (places >> (2 * corner)) & 3; }

/// Where a facet goes, in one place: its neighbours ask for both.
struct Placed {
  std::uint32_t tet;
  Places places;
};

/// Puts corners in ascending order, infinity last; the last two change places if that keeps the
/// orientation. Straight to where they stay: put together elsewhere and copied at once, they would
/// wait for each other, a thirtieth of the hull's time.
Places put_in_order(const std::array<Site, 4>& corners, Corners& to) {
  std::array<std::uint64_t, 4> keys;
  for (std::size_t i = 0; i < 4; ++i) keys[i] = std::uint64_t{corners[i]} << 2 | i;
  bool odd = false;
  const auto order = [&](std::size_t i, std::size_t j) {
    const bool swap = keys[i] > keys[j];
    const std::uint64_t low = swap ? keys[j] : keys[i];
    keys[j] = swap ? keys[i] : keys[j];
    keys[i] = low;
    odd ^= swap;
  };
  order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
  if (odd) std::swap(keys[2], keys[3]);
  Places places = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    to[k] = VertexId{static_cast<std::uint32_t>(keys[k] >> 2)};
    places = static_cast<Places>(places | k << (2 * (keys[k] & 3)));
  }
  return places;
}

class Output {
 public:
  Output(LargeBlock<FacetLinks> facets, std::size_t site_count, int threads)
      : facets_(std::move(facets)),
        threads_(threads),
        facet_count_(facets_.capacity()),
        first_(2 * site_count + 1, 0) {}

  LiftedHull run(const std::function<void(double)>& progress) {
    const auto told = [&](double share) {
      if (progress) progress(share);
    };
    LiftedHull hull;
    count_buckets();
    told(0.1);
    hull.finite_count = first_[first_.size() / 2];
    share_buckets();
    hull.tets.resize(count_);
    scatter(hull.tets);
    told(0.4);
    sort_buckets(hull.tets);
    told(0.6);
    hull.neighbors.resize(count_);
    write_neighbors(hull.neighbors);
    told(1);
    return hull;
  }

 private:
  /// So many are sorted by counting.
  static constexpr std::uint32_t kFew = 64;
  struct Item {
    std::uint64_t key;
    Corners corners;
    FacetIndex facet;
  };

  /// One bucket per lowest corner; those of infinite facets come after all others.
  std::size_t bucket(FacetIndex f) const {
    const auto& c = facets_[f].corners;
    const std::size_t lowest = std::min(std::min(c[0], c[1]), std::min(c[2], c[3]));
    return facets_[f].infinite() ? lowest + first_.size() / 2 : lowest;
  }
  /// The count before. An atomic operation waits for all stores before it: a tenth of the hull's
  /// time, if one thread did it for nothing.
  std::uint32_t count_one_up(std::size_t b) {
    if (threads_ <= 1) return first_[b]++;
    return std::atomic_ref(first_[b]).fetch_add(1, std::memory_order_relaxed);
  }

  void count_buckets() {
    parallel_ranges(facet_count_, threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f) {
        if (facets_[f].lives()) count_one_up(bucket(static_cast<FacetIndex>(f)));
      }
    });
    std::exclusive_scan(first_.begin(), first_.end(), first_.begin(), 0u);
    count_ = first_.back();
  }

  /// Shares the buckets out among the threads, by what is in them.
  void share_buckets() {
    const std::size_t parts = worth_threads(count_, threads_);
    cuts_.assign(1, 0);
    for (std::size_t part = 1; part < parts; ++part) {
      const auto cut = std::ranges::lower_bound(first_, count_ * part / parts);
      cuts_.push_back(static_cast<std::size_t>(cut - first_.begin()));
    }
    cuts_.push_back(first_.size() - 1);
  }
  /// Calls work(begin, end) on each share, on a thread of its own.
  template <class Work>
  void for_each_share(Work&& work) const {
    parallel_each(cuts_.size() - 1, [&](std::size_t part) { work(cuts_[part], cuts_[part + 1]); });
  }

  /// Puts facets into their buckets, and the ends of the buckets into first_. Each thread reads all
  /// facets for those of its share: two that fill one bucket wait for each other's cache lines, and
  /// are slower than one.
  void scatter(LargeArray<Corners>& tets) {
    facet_at_.resize(count_);
    placed_.resize(facet_count_);
    for_each_share([&](std::size_t begin, std::size_t end) {
      for (FacetIndex f = 0; f < facet_count_; ++f) {
        if (!facets_[f].lives()) continue;
        const std::size_t b = bucket(f);
        if (b < begin || b >= end) continue;
        const std::uint32_t at = first_[b]++;
        placed_[f].places = put_in_order(facets_[f].corners, tets[at]);
        facet_at_[at] = f;
      }
    });
  }

  void sort_buckets(LargeArray<Corners>& tets) {
    for_each_share([&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b) {
        sort_bucket(tets, b == 0 ? 0 : first_[b - 1], first_[b]);
      }
    });
  }

  /// Sorts by the second and third corner: no two tetrahedra have the same first three, because
  /// those around an edge, as they are oriented, lead from each third corner to one fourth.
  void sort_bucket(LargeArray<Corners>& tets, std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t size = end - begin;
    if (size > kFew) {
      sort_large_bucket(tets, begin, end);
      return;
    }
    // Counts how many come before each: no branch depends on the order they are in.
    std::array<Item, kFew> items;
    std::array<std::uint32_t, kFew> before;
    for (std::uint32_t i = 0; i < size; ++i) {
      items[i] = item(tets, begin + i);
      std::uint32_t smaller = 0;
      for (std::uint32_t k = 0; k < i; ++k) {
        const bool less = items[k].key < items[i].key;
        smaller += less;
        before[k] += !less;
      }
      before[i] = smaller;
    }
    for (std::uint32_t i = 0; i < size; ++i) put(items[i], tets, begin + before[i]);
  }

  void sort_large_bucket(LargeArray<Corners>& tets, std::uint32_t begin, std::uint32_t end) {
    std::vector<Item> items;
    for (std::uint32_t i = begin; i < end; ++i) items.push_back(item(tets, i));
    std::sort(items.begin(), items.end(),
              [](const Item& a, const Item& b) { return a.key < b.key; });
    for (std::uint32_t i = begin; i < end; ++i) put(items[i - begin], tets, i);
  }

  Item item(const LargeArray<Corners>& tets, std::uint32_t i) const {
    const Corners& c = tets[i];
    return {std::uint64_t{+c[1]} << 32 | +c[2], c, facet_at_[i]};
  }
  void put(const Item& item, LargeArray<Corners>& tets, std::uint32_t at) {
    tets[at] = item.corners;
    facet_at_[at] = item.facet;
    placed_[item.facet].tet = at;
  }

  void write_neighbors(LargeArray<std::array<FacetHandle, 4>>& neighbors) const {
    parallel_ranges(count_, threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        const FacetIndex f = facet_at_[t];
        const Places places = placed_[f].places;
        for (std::uint32_t i = 0; i < 4; ++i) {
          const Ridge r = facets_[f].neighbors[i];
          const Placed& g = placed_[facet_of(r)];
          neighbors[t][place(places, i)] = 4 * g.tet + place(g.places, corner_of(r));
        }
      }
    });
  }

  LargeBlock<FacetLinks> facets_;
  int threads_;
  std::size_t facet_count_;          ///< living and dead
  std::size_t count_ = 0;            ///< living
  LargeArray<std::uint32_t> first_;  ///< per bucket
  std::vector<std::size_t> cuts_;    ///< buckets that begin a share, and the end
  LargeArray<FacetIndex> facet_at_;  ///< per tetrahedron of the result
  LargeArray<Placed> placed_;        ///< per facet that lives
};

}  // namespace

LiftedHull output(LargeBlock<FacetLinks> facets, std::size_t site_count, int threads,
                  const std::function<void(double)>& progress) {
  return Output(std::move(facets), site_count, threads).run(progress);
}

}  // namespace tetsculpt::hull
