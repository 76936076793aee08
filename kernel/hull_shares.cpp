// How long a range takes depends on what else its processor does: in the same minutes, on a virtual
// machine, one of two halves of a million points took 430 to 690 ms, now the one and now the other.
// So threads stop when the first is done, where there is enough left to share, and each cut has as
// many of the sites left on one side as on the other.
//     Blocks of sites are halved by planes, and again for more threads, in each pass across another
// axis first, the longest side of the set to begin with. What was not inserted after one, two and
// three passes when no thread stops early, of the last round of a million points on two threads:
// cube 4.8, 0.3 and 0.01 %, bumpy sphere 13, 2.3 and 0.6 %, a scanned statue 2.5, 0.2 and 0.04 %.
// On a torus 38 %: around the hole tetrahedra reach all around, within the tube they reach around
// the tube, and any cut meets one or the other. So passes that brought little in a round before are
// left out, unless they would spread what a slow thread left. To find that a point can't go in
// takes little, see Inserter::sees_beyond.
//     Before, ranges were octants of the curve, halves of a cube and of nothing else: on the bumpy
// sphere 25 % waited, and what a thread left when it stopped lay in one corner. All four scans of
// 270,000 points to a million now take 0.89 to 0.95 of the time, the cube 0.94, the bumpy sphere
// 0.98 (two threads, medians of 15 to 40 pairs). Without gain: threads that take their ranges in
// small pieces from all over (64 per octant 4 % slower than 8), known facets and their neighbours
// asked for some sites ahead in later passes.
//     What is left comes last, on one thread, and a point takes three times as long there: its
// neighbourhood is in no cache. A thousand points per thread are worth another pass.
#include "kernel/hull_shares.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <numeric>
#include <utility>

#include "kernel/box.h"
#include "kernel/parallel.h"

namespace tetsculpt::hull {
namespace {

/// Sites that are worth a thread.
constexpr std::size_t kWorthAThread = 1024;

/// Also where an exception ends what it is for.
struct SetAtEnd {
  std::atomic<bool>& flag;
  ~SetAtEnd() { flag = true; }
};

/// A plane across an axis, and the share of sites below it.
struct Cut {
  double at = 0;
  double below = 0;
};

/// Of sites in blocks, about a share below.
template <class Blocks>
Cut cut_across(std::size_t axis, double share, const Blocks& blocks, const SiteSet& sites) {
  constexpr std::size_t kSample = 4096;
  struct Sampled {
    double at;
    std::size_t count;
  };
  std::vector<Sampled> sample;
  const auto has_any = [&](const auto& block) { return sites.count_in(block.index) > 0; };
  const auto filled = static_cast<std::size_t>(std::ranges::count_if(blocks, has_any));
  std::size_t k = 0;
  for (const auto& block : blocks) {
    if (!has_any(block) || k++ % (filled / kSample + 1) != 0) continue;
    sample.push_back({block.at[axis], sites.count_in(block.index)});
  }
  std::ranges::sort(sample, {}, &Sampled::at);
  const auto add = [](std::size_t sum, const Sampled& s) { return sum + s.count; };
  const auto all =
      static_cast<double>(std::accumulate(sample.begin(), sample.end(), std::size_t{0}, add));
  Cut cut;
  double below = 0;
  for (const Sampled& s : sample) {
    if (s.at > cut.at || below == 0) cut = {s.at, below / all};
    if (below >= share * all) break;
    below += static_cast<double>(s.count);
  }
  return cut;
}

}  // namespace

Shares::Shares(std::span<const Point3> points, Facets& facets, Inserter& inserter)
    : points_(points), facets_(facets), inserter_(inserter) {}

void Shares::insert(SiteSet& sites, std::size_t threads, const Told& told) {
  if (blocks_.empty()) set_blocks();
  while (helpers_.size() < threads) helpers_.push_back(inserter_.helper());
  own_.resize(threads);
  inserter_.mark_free();
  helpers_[0].take_over(inserter_);
  const std::size_t all = sites.count();
  std::size_t left = all;
  std::size_t untried = 0;
  for (passes_ = 0; worth_sharing(left); ++passes_) {
    if (passes_ > 0 && untried <= left / 2 && failing_from(passes_)) break;
    const std::size_t tried = pass(sites, [&](std::size_t k) { told(all - left + k); });
    const std::size_t before = std::exchange(left, sites.count());
    untried = before - tried;
    const bool failing = before - left <= tried / 4;
    if (passes_ < kAxes) {
      failing_[passes_] = failing;
    } else if (failing) {
      break;
    }
  }
  for (Inserter& helper : helpers_) inserter_.take_over(helper);
}

/// Whether little went in at all turns from this one on; of an earlier round, if there was one.
bool Shares::failing_from(std::size_t turn) const {
  return turn < kAxes && std::all_of(failing_.begin() + static_cast<std::ptrdiff_t>(turn),
                                     failing_.end(), std::identity());
}

/// Cuts the longest side first.
void Shares::set_blocks() {
  Box box;
  for (std::size_t b = 0; b * kBlock < points_.size(); ++b) {
    const Point3& p = points_[std::min(b * kBlock + kBlock / 2, points_.size() - 1)];
    blocks_.push_back({static_cast<std::uint32_t>(b), {p.x, p.y, p.z}});
    box.include(p);
  }
  const std::array<double, kAxes> sides{box.high.x - box.low.x, box.high.y - box.low.y,
                                        box.high.z - box.low.z};
  std::ranges::stable_sort(axes_, std::ranges::greater{}, [&](std::size_t a) { return sides[a]; });
}

bool Shares::worth_sharing(std::size_t count) const { return count / kWorthAThread >= own_.size(); }

/// Cuts blocks into parts for so many threads from the first on, each with as many of the sites.
void Shares::assign(std::span<Block> blocks, std::size_t first, std::size_t threads,
                    std::size_t turn, const SiteSet& sites) {
  if (threads == 1) {
    own_[first].assign(blocks_.size(), 0);
    own_[first].push_back(1);
    for (const Block& b : blocks) own_[first][b.index] = 1;
    return;
  }
  // Three halvings take all axes, in whatever order: not in the middle each time.
  const std::size_t off = threads < 4 ? 0 : passes_ % kAxes;
  const std::size_t lower = threads / 2 + (off == 2 ? 1 : 0) - (off == 1 ? 1 : 0);
  const double share_below = static_cast<double>(lower) / static_cast<double>(threads);
  std::size_t axis = 0;
  Cut cut;
  // Another axis where many are in one plane.
  for (std::size_t tries = 0; tries < kAxes; ++tries) {
    axis = axes_[turn++ % kAxes];
    cut = cut_across(axis, share_below, blocks, sites);
    if (cut.below > share_below / 2) break;
  }
  const auto upper = std::partition(blocks.begin(), blocks.end(),
                                    [&](const Block& b) { return b.at[axis] < cut.at; });
  const auto size = static_cast<std::size_t>(upper - blocks.begin());
  assign(blocks.first(size), first, lower, turn, sites);
  assign(blocks.subspan(size), first + lower, threads - lower, turn, sites);
}

/// Returns how many sites were tried.
std::size_t Shares::pass(SiteSet& sites, const Told& told) {
  constexpr std::size_t kTellEvery = 65536;
  const std::size_t threads = own_.size();
  assign(blocks_, 0, threads, passes_, sites);
  std::vector<std::size_t> todo(threads);
  parallel_each(threads, [&](std::size_t t) {
    std::size_t sum = 0;
    for (std::size_t b = 0; b < blocks_.size(); ++b) sum += own_[t][b] * sites.count_in(b);
    todo[t] = sum;
    helpers_[t].move_to(SiteRange(own_[t]), sites);
  });
  facets_.share();
  std::atomic<bool> over = false;
  std::vector<std::size_t> tried(threads);
  parallel_each(threads, [&](std::size_t t) {
    const SetAtEnd at_end{over};
    Inserter& helper = helpers_[t];
    std::size_t k = 0;
    const auto attempt = [&](Site s) {
      if (over.load(std::memory_order_relaxed) && worth_sharing(todo[t] - k)) return false;
      if (helper.insert(s)) sites.erase(s);
      if (t == 0 && k % kTellEvery == 0) told(k);
      ++k;
      return true;
    };
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      if (own_[t][b] != 0 && !sites.each_in(b, attempt)) break;
    }
    tried[t] = k;
  });
  facets_.unshare();
  for (const Inserter& helper : helpers_) inserter_.begin_at_last_of(helper);
  return std::accumulate(tried.begin(), tried.end(), std::size_t{0});
}

}  // namespace tetsculpt::hull
