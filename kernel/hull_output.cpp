#include "kernel/hull_output.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/hull_bucket.h"
#include "kernel/large_array.h"
#include "kernel/large_block.h"
#include "kernel/parallel.h"

namespace tetsculpt::hull {
namespace {

class Output {
 public:
  Output(Facets& facets, std::size_t site_count, int threads, bool by_four)
      : threads_(threads), by_four_(by_four), bucket_count_(2 * site_count) {
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
      const auto write = by_four_ ? write_bucket_by_four : write_bucket;
      for (std::size_t b = begin; b < end; ++b) {
        write(&facets_[0], facet_at_, begin_of(b), end_[b], hull);
      }
    });
    told(0.8);
    number_neighbors(hull.neighbors);
    told(1);
    return hull;
  }

 private:
  /// Threads that take facets: each has a table of all buckets.
  static constexpr int kMostTakers = 4;
  /// What is needed so many steps later is asked for: it lies anywhere in memory.
  static constexpr std::size_t kAhead = 16;
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
    for (auto& next : next_) next.resize(bucket_count_);
    parallel_each(next_.size(), [&](std::size_t thread) { std::ranges::fill(next_[thread], 0); });
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

  /// Cuts the buckets into shares of about as much.
  void share_buckets() {
    cuts_ = share_cuts(count_, threads_);
    for (std::size_t& cut : cuts_) {
      cut = static_cast<std::size_t>(std::ranges::lower_bound(end_, cut) - end_.begin());
    }
    cuts_.back() = bucket_count_;
  }
  /// Calls work(begin, end) on each share.
  template <class Work>
  void for_each_share(Work&& work) const {
    parallel_shares(cuts_.size() - 1, threads_,
                    [&](std::size_t part) { work(cuts_[part], cuts_[part + 1]); });
  }

  /// From ridges of facets to facets of tetrahedra.
  void number_neighbors(LargeArray<std::array<FacetHandle, 4>>& neighbors) const {
    for_each_share([&](std::size_t first_bucket, std::size_t end_bucket) {
      const std::size_t end = begin_of(end_bucket);
      for (std::size_t t = begin_of(first_bucket); t < end; ++t) {
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
  bool by_four_;
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

LiftedHull output(Facets& facets, std::size_t site_count, int threads, bool by_four,
                  const std::function<void(double)>& progress) {
  return Output(facets, site_count, threads, by_four).run(progress);
}

}  // namespace tetsculpt::hull
