// How long a stretch takes depends on what else its processor does: in the same minutes, on a
// virtual machine, one of two halves of a million points took 430 to 690 ms, now the one and now
// the other. So threads stop when the first is done, where there is enough left to share. They wait
// for each other some milliseconds then, instead of 30 to 120. Points of which one was tried to no
// avail are mostly not tried, see Inserter::defer_at_border. Both together: two threads take 0.87
// of their time on a million points of a bumpy sphere, 0.72 on a torus, 0.94 to 0.97 on a cube.
//     Smaller rests shared out, too, bring less: a short stretch is nearly all border, and on a
// sphere all of it waits. What waits, cut evenly at once instead of by the whole curve, leaves nine
// times as many points, because cuts gather where points wait.
#include "kernel/hull_stretches.h"

#include <algorithm>
#include <atomic>

#include "kernel/parallel.h"

namespace tetsculpt::hull {
namespace {

/// Also where an exception ends what it is for.
struct SetAtEnd {
  std::atomic<bool>& flag;
  ~SetAtEnd() { flag = true; }
};

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

std::vector<Site> Stretches::insert(std::vector<Site> sites, std::vector<Site> cuts,
                                    const Told& told) {
  std::rotate(sites.begin(), std::ranges::lower_bound(sites, cuts[0]), sites.end());
  const std::size_t all = sites.size();
  std::vector<Site> left;
  while (!sites.empty()) {
    const std::size_t in = all - sites.size();
    sites = insert_until_one_is_done(sites, cuts, [&](std::size_t k) { told(in + k); });
    if (!sites.empty()) cuts = even_cuts(sites);
    std::vector<Site> deferred = take_deferred();
    deferred.insert(deferred.end(), left.begin(), left.end());
    std::ranges::inplace_merge(deferred, deferred.end() - static_cast<std::ptrdiff_t>(left.size()));
    left = std::move(deferred);
  }
  return left;
}

/// In ascending order.
std::vector<Site> Stretches::take_deferred() {
  std::vector<Site> all;
  for (Inserter& helper : helpers_) {
    const std::vector<Site> deferred = helper.take_deferred();
    all.insert(all.end(), deferred.begin(), deferred.end());
  }
  if (!std::ranges::is_sorted(all)) std::ranges::sort(all);  // stretches may go on at the beginning
  return all;
}

/// How far on along the curve, which closes on itself.
std::size_t Stretches::along(Site s, Site from) const {
  return s >= from ? s - from : s + site_count_ - from;
}

/// Where stretches begin in a list that begins with the first one, and the end.
std::vector<std::size_t> Stretches::begin_in(const std::vector<Site>& sites,
                                             const std::vector<Site>& cuts) const {
  const auto place = [&](Site s) { return along(s, cuts[0]); };
  std::vector<std::size_t> begin;
  for (const Site cut : cuts) {
    const auto first = std::ranges::lower_bound(sites, place(cut), {}, place);
    begin.push_back(static_cast<std::size_t>(first - sites.begin()));
  }
  begin.push_back(sites.size());
  return begin;
}

/// Returns what is left of the stretches, in their order, where it is worth sharing.
std::vector<Site> Stretches::insert_until_one_is_done(const std::vector<Site>& sites,
                                                      const std::vector<Site>& cuts,
                                                      const Told& told) {
  constexpr std::size_t kTellEvery = 65536;
  const std::size_t threads = helpers_.size();
  const auto worth_sharing = [&](std::size_t n) {
    return worth_threads(n, static_cast<int>(threads)) == threads;
  };
  const std::vector<std::size_t> begin = begin_in(sites, cuts);
  parallel_each(threads, [&](std::size_t t) {
    const auto stretch = std::span(sites).subspan(begin[t], begin[t + 1] - begin[t]);
    helpers_[t].move_to({cuts[t], cuts[(t + 1) % threads]}, stretch, site_count_);
  });
  facets_.share();
  std::atomic<bool> over = false;
  std::vector<std::size_t> end(threads);
  parallel_each(threads, [&](std::size_t t) {
    const SetAtEnd at_end{over};
    std::size_t k = begin[t];
    for (; k < begin[t + 1]; ++k) {
      if (over.load(std::memory_order_relaxed) && worth_sharing(begin[t + 1] - k)) break;
      helpers_[t].insert(sites[k]);
      if (t == 0 && k % kTellEvery == 0) told(k);
    }
    end[t] = k;
  });
  facets_.unshare();
  for (const Inserter& helper : helpers_) inserter_.begin_at_last_of(helper);
  std::vector<Site> left;
  for (std::size_t t = 0; t < threads; ++t) {
    left.insert(left.end(), sites.begin() + static_cast<std::ptrdiff_t>(end[t]),
                sites.begin() + static_cast<std::ptrdiff_t>(begin[t + 1]));
  }
  return left;
}

/// Such that each stretch has as many of the sites. The first begins where there are none: halfway
/// between the last of them and the first.
std::vector<Site> Stretches::even_cuts(const std::vector<Site>& sites) const {
  const std::size_t gap = along(sites.front(), sites.back());
  std::vector<Site> cuts;
  cuts.push_back(static_cast<Site>((sites.back() + (gap + 1) / 2) % site_count_));
  for (std::size_t t = 1; t < helpers_.size(); ++t) {
    cuts.push_back(sites[sites.size() * t / helpers_.size()]);
  }
  return cuts;
}

}  // namespace tetsculpt::hull
