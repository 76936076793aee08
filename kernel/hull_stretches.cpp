// How long a range takes depends on what else its processor does: in the same minutes, on a virtual
// machine, one of two halves of a million points took 430 to 690 ms, now the one and now the other.
// So threads stop when the first is done, where there is enough left to share, and what is left
// comes first in the next pass, so that what remains then is spread again.
//     Cuts along all three axes of a cube: on a bumpy sphere 25 % of the points do not go in in the
// first pass, 1.3 % in the second and 0.3 % in the third. (A torus is round: of the points around
// its hole, 36 % of all, none goes in as long as anything is cut.) To find that a point can't go in
// takes little, see Inserter::sees_beyond.
//     What is left, cut evenly each time, leaves nine times as many points, because cuts gather
// where points wait: a small piece is nearly all border. That is only done where most of what is
// left was not tried. A pass along all the curve begins with 4 to 6 ms at a million points, to see
// which facets are still known.
#include "kernel/hull_stretches.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <span>
#include <utility>

#include "kernel/parallel.h"

namespace tetsculpt::hull {
namespace {

/// Passes with next_ranges() that have no border in common.
constexpr std::size_t kCycle = 3;

/// Also where an exception ends what it is for.
struct SetAtEnd {
  std::atomic<bool>& flag;
  ~SetAtEnd() { flag = true; }
};

void append(std::span<const Site> more, std::vector<Site>& sites) {
  sites.insert(sites.end(), more.begin(), more.end());
}

void sort(std::vector<Site>& sites) {
  if (!std::ranges::is_sorted(sites)) std::ranges::sort(sites);
}

}  // namespace

Stretches::Stretches(Facets& facets, Inserter& inserter, std::size_t site_count,
                     std::size_t threads)
    : facets_(facets), inserter_(inserter), site_count_(site_count) {
  inserter_.mark_free();
  for (std::size_t t = 0; t < threads; ++t) helpers_.push_back(inserter_.helper());
}

void Stretches::end() {
  for (const Inserter& helper : helpers_) inserter_.take_over(helper);
  helpers_.clear();
}

std::vector<Site> Stretches::insert(std::vector<Site> sites, const Told& told) {
  const std::size_t all = sites.size();
  while (worth_sharing(sites.size())) {
    const std::size_t before = sites.size();
    sites = pass(sites, [&](std::size_t k) { told(all - before + k); });
    if (moves_ >= kCycle && sites.size() > before / 4 * 3) break;
  }
  return sites;
}

bool Stretches::worth_sharing(std::size_t count) const {
  return worth_threads(count, static_cast<int>(helpers_.size())) == helpers_.size();
}

/// Of equal parts of the curve. With two threads these are octants of a cube, as the curve has
/// them, four for each: 0 to 3, then 2 to 5, then 1, 2, 5 and 6, halves along one axis, along
/// another and along the third.
std::vector<SiteRange> Stretches::next_ranges() {
  const std::size_t threads = helpers_.size();
  const std::size_t parts = 4 * threads;
  const auto arc = [&](std::size_t begin, std::size_t size) {
    const auto cut = [&](std::size_t part) {
      return static_cast<Site>(site_count_ * (part % parts) / parts);
    };
    return Arc{cut(begin), cut(begin + size)};
  };
  const std::size_t kind = moves_++ % kCycle;
  std::vector<SiteRange> ranges;
  for (std::size_t t = 0; t < threads; ++t) {
    if (kind < 2) {
      ranges.push_back({arc(4 * t + 2 * kind, 4), {}});
    } else {
      ranges.push_back({arc(2 * t + 1, 2), arc(2 * (t + threads) + 1, 2)});
    }
  }
  return ranges;
}

/// Such that each has as many of the sites, which are in ascending order. The first begins where
/// there are none: halfway between the last of them and the first.
std::vector<SiteRange> Stretches::even_ranges(std::span<const Site> sites) const {
  const std::size_t gap = site_count_ - sites.back() + sites.front();
  std::vector<Site> cuts{static_cast<Site>((sites.back() + (gap + 1) / 2) % site_count_)};
  for (std::size_t t = 1; t < helpers_.size(); ++t) {
    cuts.push_back(sites[sites.size() * t / helpers_.size()]);
  }
  std::vector<SiteRange> ranges;
  for (std::size_t t = 0; t < cuts.size(); ++t) {
    ranges.push_back({{cuts[t], cuts[(t + 1) % cuts.size()]}, {}});
  }
  return ranges;
}

/// Returns each helper's part of the sites, in their order.
std::vector<std::vector<Site>> Stretches::move_to(const std::vector<SiteRange>& ranges,
                                                  std::span<const Site> sites) {
  std::vector<std::vector<Site>> parts(helpers_.size());
  parallel_each(helpers_.size(), [&](std::size_t t) {
    std::vector<Site> own;  // on the thread's own stack while it grows
    own.reserve(sites.size() / helpers_.size());
    const auto in_range = [&](Site s) { return ranges[t].contains(s); };
    std::ranges::copy_if(sites, std::back_inserter(own), in_range);
    helpers_[t].move_to(ranges[t], own);
    parts[t] = std::move(own);
  });
  return parts;
}

/// Returns what threads have not tried, and then what could not go in, both in ascending order.
std::vector<Site> Stretches::pass(std::span<const Site> sites, const Told& told) {
  constexpr std::size_t kTellEvery = 65536;
  const bool even = untried_ > sites.size() / 2;
  const std::vector<std::vector<Site>> parts =
      move_to(even ? even_ranges(sites.first(untried_)) : next_ranges(), sites);
  facets_.share();
  std::atomic<bool> over = false;
  std::vector<std::size_t> tried(helpers_.size());
  parallel_each(helpers_.size(), [&](std::size_t t) {
    const SetAtEnd at_end{over};
    const std::span<const Site> own = parts[t];
    std::size_t k = 0;
    for (; k < own.size(); ++k) {
      if (over.load(std::memory_order_relaxed) && worth_sharing(own.size() - k)) break;
      helpers_[t].insert(own[k]);
      if (t == 0 && k % kTellEvery == 0) told(k);
    }
    tried[t] = k;
  });
  facets_.unshare();
  std::vector<Site> left;
  std::vector<Site> deferred;
  for (std::size_t t = 0; t < helpers_.size(); ++t) {
    inserter_.begin_at_last_of(helpers_[t]);
    append(std::span(parts[t]).subspan(tried[t]), left);
    append(helpers_[t].take_deferred(), deferred);
  }
  sort(left);
  sort(deferred);
  untried_ = left.size();
  append(deferred, left);
  return left;
}

}  // namespace tetsculpt::hull
