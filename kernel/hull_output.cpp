#include "kernel/hull_output.h"

#include <algorithm>
#include <array>
#include <bit>
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

/// How four corners are put in ascending order, infinity last; the last two change places if that
/// keeps the orientation.
struct Order {
  std::array<std::uint8_t, 4> corner_at{};  ///< per place
  std::array<std::uint32_t, 4> place_of{};  ///< per corner
};

/// Six bits: of corners 1 0, 2 0, 3 0, 2 1, 3 1 and 3 2, whether the first is less.
using Comparisons = std::uint8_t;

constexpr Comparisons compare(const std::array<Site, 4>& c) {
  std::uint32_t bits = c[1] < c[0];
  bits += bits + (c[2] < c[0]);
  bits += bits + (c[3] < c[0]);
  bits += bits + (c[2] < c[1]);
  bits += bits + (c[3] < c[1]);
  bits += bits + (c[3] < c[2]);
  return static_cast<Comparisons>(bits);
}

constexpr auto kOrders = [] {
  std::array<Order, 64> orders{};
  std::array<Site, 4> rank{0, 1, 2, 3};
  do {
    const Comparisons bits = compare(rank);
    const auto odd = static_cast<std::uint32_t>(std::popcount(bits)) & 1;
    for (std::uint8_t i = 0; i < 4; ++i) {
      const std::uint32_t place = rank[i] ^ (odd & rank[i] >> 1);
      orders[bits].place_of[i] = place;
      orders[bits].corner_at[place] = i;
    }
  } while (std::next_permutation(rank.begin(), rank.end()));
  return orders;
}();

class Output {
 public:
  Output(Facets& facets, std::size_t site_count, int threads)
      : threads_(threads), bucket_count_(2 * site_count) {
    take(facets);
  }

  LiftedHull run(const std::function<void(double)>& progress) {
    const auto told = [&](double share) {
      if (progress) progress(share);
    };
    told(0.2);
    fill_buckets();
    share_buckets();
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
  /// Threads that take facets: each has a table of all buckets.
  static constexpr int kMostTakers = 4;
  /// So many are sorted by counting.
  static constexpr std::uint32_t kFew = 64;
  /// What is needed so many steps later is asked for: it lies anywhere in memory.
  static constexpr std::size_t kAhead = 16;

  struct Item {
    Corners corners;
    FacetIndex facet;
    Comparisons comparisons;

    /// Sorts a bucket: no two tetrahedra have the same first three corners, because those around an
    /// edge, as they are oriented, lead from each third corner to one fourth.
    std::uint64_t key() const { return std::uint64_t{+corners[1]} << 32 | +corners[2]; }
  };

  /// One bucket per lowest corner; those of infinite facets come after all others.
  static std::size_t bucket(const FacetLinks& facet, std::size_t bucket_count) {
    const auto& c = facet.corners;
    const std::size_t lowest = std::min(std::min(c[0], c[1]), std::min(c[2], c[3]));
    return facet.infinite() ? lowest + bucket_count / 2 : lowest;
  }
  std::uint32_t begin_of(std::size_t b) const { return b == 0 ? 0 : end_[b - 1]; }

  /// Takes the facets and counts what each thread will put into each bucket: where it begins with
  /// that.
  void take(Facets& facets) {
    taken_ = facets.size();
    next_.resize(worth_threads(taken_, std::min(threads_, kMostTakers)));
    for (auto& next : next_) next.resize(bucket_count_, 0);
    facets_ = facets.take_links(takers(), [&](std::size_t thread) {
      return [next = next_[thread].data(), count = bucket_count_](const FacetLinks& facet) {
        if (facet.lives()) ++next[bucket(facet, count)];
      };
    });
    std::uint32_t sum = 0;
    for (std::size_t b = 0; b < bucket_count_; ++b) {
      for (auto& next : next_) sum += std::exchange(next[b], sum);
    }
    count_ = sum;
  }

  /// Lists the facets by bucket and puts the ends of the buckets into end_. Each thread lists those
  /// that it took.
  void fill_buckets() {
    facet_at_.resize(count_);
    parallel_each(next_.size(), [&](std::size_t thread) {
      LargeBlock<Facet>::reduced_ranges(
          taken_, takers(), thread,
          [facets = &facets_[0], to = facet_at_.data(), next = next_[thread].data(),
           count = bucket_count_](std::size_t begin, std::size_t end) {
            for (std::size_t f = begin; f < end; ++f) {
              if (!facets[f].lives()) continue;
              to[next[bucket(facets[f], count)]++] = static_cast<FacetIndex>(f);
            }
          });
    });
    end_ = std::move(next_.back());
    next_.clear();
  }
  int takers() const { return static_cast<int>(next_.size()); }

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

  /// Writes the tetrahedra of a bucket in their order.
  void write_bucket(LiftedHull& hull, std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t size = end - begin;
    if (size > kFew) return write_large_bucket(hull, begin, end);
    std::array<Item, kFew> items;
    std::array<std::uint64_t, kFew> keys;
    for (std::uint32_t i = 0; i < size; ++i) {
      items[i] = item(begin + i);
      keys[i] = items[i].key();
    }
    // Counts how many come before each: no branch depends on the order they are in.
    for (std::uint32_t i = 0; i < size; ++i) {
      std::uint32_t before = 0;
      for (std::uint32_t k = 0; k < size; ++k) before += keys[k] < keys[i];
      put(items[i], hull, begin + before);
    }
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
    const std::array<Site, 4>& corners = facets_[item.facet].corners;
    item.comparisons = compare(corners);
    const Order& order = kOrders[item.comparisons];
    for (std::size_t p = 0; p < 4; ++p) item.corners[p] = VertexId{corners[order.corner_at[p]]};
    return item;
  }

  /// The facets of the tetrahedron take the place of the facet's own corners.
  void put(const Item& item, LiftedHull& hull, std::uint32_t at) {
    const Order& order = kOrders[item.comparisons];
    FacetLinks& facet = facets_[item.facet];
    hull.tets[at] = item.corners;
    for (std::size_t p = 0; p < 4; ++p) {
      hull.neighbors[at][p] = facet.neighbors[order.corner_at[p]];
    }
    for (std::size_t i = 0; i < 4; ++i) facet.corners[i] = 4 * at + order.place_of[i];
  }

  /// From ridges of facets to facets of tetrahedra.
  void number_neighbors(LargeArray<std::array<FacetHandle, 4>>& neighbors) const {
    parallel_ranges(count_, threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        const auto& later = neighbors[std::min(t + kAhead, end - 1)];
        for (std::uint32_t i = 0; i < 4; ++i) {
          __builtin_prefetch(&facets_[facet_of(later[i])]);
          const Ridge r = neighbors[t][i];
          neighbors[t][i] = facets_[facet_of(r)].corners[corner_of(r)];
        }
      }
    });
  }

  int threads_;
  std::size_t bucket_count_;
  LargeBlock<FacetLinks> facets_;  ///< living and dead
  std::size_t taken_ = 0;
  std::size_t count_ = 0;                        ///< living
  std::vector<LargeArray<std::uint32_t>> next_;  ///< per thread and bucket
  LargeArray<std::uint32_t> end_;                ///< per bucket
  std::vector<std::size_t> cuts_;                ///< buckets that begin a share, and the end
  LargeArray<FacetIndex> facet_at_;              ///< per tetrahedron, in the order of buckets
};

}  // namespace

LiftedHull output(Facets& facets, std::size_t site_count, int threads,
                  const std::function<void(double)>& progress) {
  return Output(facets, site_count, threads).run(progress);
}

}  // namespace tetsculpt::hull
