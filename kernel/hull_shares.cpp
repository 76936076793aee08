// How long a range takes depends on what else its processor does: in the same minutes, on a virtual
// machine, one of two halves of a million points took 430 to 690 ms, now the one and now the other.
// So threads stop when the first is done, where there is enough left to share, and each cut has as
// many of the sites left on one side as on the other.
//     Blocks of sites are halved by planes, and again for more threads, in each pass across another
// axis first, the longest side of the set to begin with. What was not inserted after one, two and
// three passes when no thread stops early, of the last round of a million points on two threads:
// cube 4.7, 0.25 and 0.01 %, bumpy sphere 13, 2.2 and 0.3 %, a scanned statue 2.5, 0.25 and 0.04 %.
// On a torus 38 %: around the hole tetrahedra reach all around, within the tube they reach around
// the tube, and any cut meets one or the other. So passes that brought little in a round before are
// left out, unless they would spread what a slow thread left. To find that a point can't go in
// takes little, see Inserter::sees_beyond.
//     2,000 to 2,700 points of a million could go in in no pass, until helpers began at any facet
// they know in their range, and facets that are known outlived ranges they do not serve: 0.93 to
// 0.97 of the time. Without gain: ranges that threads take in small pieces from all over the curve
// (64 per octant 4 % slower than 8); known facets and their neighbours asked for some sites ahead
// in later passes, or walked from first; blocks of 8; points that wait for the next round's (those
// near two planes meet a coarse hull there, and wait again: 1.03 to 1.09); fields of a chessboard,
// first those of one colour, then the others, each thread owning what is nearest to its own (0.4 %
// of a cube's points wait and 4.5 % of a bumpy sphere's, but threads wait for each other twice as
// often: 1.01 and 1.02); threads that go on unless 16,384 or 65,536 sites are left for others.
//     What passes by corners leave goes in by the centers of facets' spheres, cut across diagonals.
// A torus has one medial axis around the tube and one through the hole: a cut across a diagonal
// meets each in a few points, half of all points have both their spheres on one side of it, and
// nearly all others on one side of its mirror image. A million points of a torus: 340,000 were left
// to one thread, now some 5,000. Two threads took 0.85 of one's time for the whole complex, 0.64
// with diagonals in any order and passes that from half way on found no room for facets, and now
// 0.57. (A tenth of what the hull takes two threads: ridges to facets that turn out to be hidden
// are looked for at the visible ones, not at the hidden ones, whose other neighbours had to be
// loaded to see whose they are.) By centers from the start: 4 % of a cube's points wait and
// 20 % of a bumpy sphere's.
//     What is left comes last, on one thread, and a point takes three times as long there: its
// neighbourhood is in no cache. A thousand points per thread are worth another pass.
#include "kernel/hull_shares.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include "kernel/box.h"
#include "kernel/parallel.h"

namespace tetsculpt::hull {
namespace {

/// Sites that are worth a thread.
constexpr std::size_t kWorthAThread = 1024;

constexpr std::size_t kTellEvery = 65536;

/// What one thread sets and others read all the time, on a cache line of its own.
struct alignas(64) Flag {
  std::atomic<bool> set = false;
};

/// Also where an exception ends what it is for.
struct SetAtEnd {
  std::atomic<bool>& flag;
  ~SetAtEnd() { flag = true; }
};

/// A point of a block, and how many sites are left in that.
struct Sample {
  Position at;
  std::size_t count;
};

/// Of blocks in which some of so many sites are left: about as many as asked for, or all.
std::vector<Sample> sampled(const std::vector<Position>& at, const SiteSet& sites, std::size_t left,
                            std::size_t wanted) {
  const std::size_t step = std::min(at.size(), left) / wanted + 1;
  std::vector<Sample> samples;
  std::size_t k = 0;
  for (std::size_t b = 0; b < at.size(); ++b) {
    if (sites.count_in(b) > 0 && k++ % step == 0) samples.push_back({at[b], sites.count_in(b)});
  }
  return samples;
}

/// A box, from low on and below high.
struct Part {
  Position low;
  Position high;

  bool contains(const Position& at) const {
    bool inside = true;
    for (std::size_t i = 0; i < at.size(); ++i) inside &= low[i] <= at[i] && at[i] < high[i];
    return inside;
  }
};

/// Halves space, and the halves.
struct Cutter {
  std::array<std::size_t, 3> axes;  ///< across which it cuts, in turn
  std::size_t off;                  ///< where there are four or more: 1 or 2 not in the middle

  /// Into as many parts as there is room for, with about as many sites in each.
  void cut(const Part& whole, std::span<Sample> samples, std::span<Part> parts,
           std::size_t turn) const {
    if (parts.size() == 1) {
      parts[0] = whole;
      return;
    }
    std::size_t lower = parts.size() / 2;
    if (parts.size() >= 4) lower = lower + (off == 2 ? 1 : 0) - (off == 1 ? 1 : 0);
    const auto add = [](std::size_t sum, const Sample& s) { return sum + s.count; };
    const std::size_t all = std::accumulate(samples.begin(), samples.end(), std::size_t{0}, add);
    const std::size_t wanted = all * lower / parts.size();
    std::size_t axis = 0;
    Below below;
    for (std::size_t tries = 0; tries < axes.size() && 2 * below.sites <= wanted; ++tries) {
      axis = axes[turn++ % axes.size()];
      below = sort_along(axis, samples, wanted);  // few if many are in one plane
    }
    Part low = whole;
    Part high = whole;
    const double at = below.samples > 0 ? samples[below.samples].at[axis] : whole.low[axis];
    low.high[axis] = high.low[axis] = at;
    cut(low, samples.first(below.samples), parts.first(lower), turn);
    cut(high, samples.subspan(below.samples), parts.subspan(lower), turn);
  }

 private:
  struct Below {
    std::size_t samples = 0;
    std::size_t sites = 0;
  };

  /// Returns how many of the first samples have about so many sites and are below all others.
  static Below sort_along(std::size_t axis, std::span<Sample> samples, std::size_t wanted) {
    std::ranges::sort(samples, {}, [&](const Sample& s) { return s.at[axis]; });
    Below below;
    std::size_t sum = 0;
    for (std::size_t k = 0; k < samples.size() && sum < wanted; sum += samples[k++].count) {
      if (k > 0 && samples[k - 1].at[axis] < samples[k].at[axis]) below = {k, sum};
    }
    return below;
  }
};

}  // namespace

Shares::Shares(std::span<const Point3> points, Facets& facets, Inserter& inserter, int threads)
    : at_((points.size() + kBlock - 1) / kBlock), facets_(facets), inserter_(inserter) {
  parallel_ranges(at_.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      const Point3& p = points[std::min(b * kBlock + kBlock / 2, points.size() - 1)];
      at_[b] = {p.x, p.y, p.z};
    }
  });
  Box box;
  for (const auto& [x, y, z] : at_) box.include({x, y, z});
  const std::array<double, kAxes> sides{box.high.x - box.low.x, box.high.y - box.low.y,
                                        box.high.z - box.low.z};
  std::ranges::stable_sort(axes_, std::ranges::greater{}, [&](std::size_t a) { return sides[a]; });
}

void Shares::insert(SiteSet& sites, std::size_t threads, const Told& told) {
  while (helpers_.size() < threads) helpers_.push_back(inserter_.helper());
  own_.resize(threads);
  for (auto& own : own_) own.assign(sites.block_count() + 1, 1);
  inserter_.mark_free();
  helpers_[0].take_over(inserter_);
  const std::size_t all = sites.count();
  std::size_t left = all;
  const Told told_further = [&](std::size_t now) { told(all - left + now); };
  left = pass_by_corners(sites, left, told_further);
  left = pass_by_centers(sites, left, told_further);
  for (Inserter& helper : helpers_) inserter_.take_over(helper);
  inserter_.insert_all(sites, [&](std::size_t k) {
    if (k % kTellEvery == 0) told_further(k);
    return true;
  });
  assert(sites.count() == 0);
}

/// Passes in which each thread has the facets whose corners are all on its side of a cut. How many
/// are left comes back.
std::size_t Shares::pass_by_corners(SiteSet& sites, std::size_t left, const Told& told) {
  const std::size_t all = left;
  const RangeOf by_corners = [](const SiteRange& own, const Position&, const Position&) {
    return Range(own);
  };
  std::size_t untried = 0;
  double first_share = 0;  // so much went in of what was tried for the first time
  for (std::size_t k = 0; worth_sharing(left); ++k) {
    if (k > 0 && untried <= left / 2 && failing_from(k)) break;
    const auto [tried, inserted] = pass(sites, left, {at_, axes_, k % kAxes}, by_corners,
                                        [&](std::size_t now) { told(all - left + now); });
    // Whether little of what did not go in before went in now.
    const auto anew = static_cast<double>(std::min(untried, tried));
    const double again = static_cast<double>(tried) - anew;
    const bool failing = static_cast<double>(inserted) - first_share * anew <= again / 4;
    if (k == 0) first_share = static_cast<double>(inserted) / std::max(again, 1.0);
    untried = left - tried;
    left -= inserted;
    if (k < kAxes) {
      failing_[k] = failing;
    } else if (failing) {
      break;
    }
  }
  return left;
}

/// The same by the centers of facets' spheres, for what is left: each diagonal in turn, and after
/// it its mirror image across the shortest side of the set. A point whose spheres on either side of
/// a surface are on either side of the first cut has them on one side of that one.
std::size_t Shares::pass_by_centers(SiteSet& sites, std::size_t left, const Told& told) {
  const std::size_t all = left;
  std::vector<Position> at(at_.size());
  std::size_t failing = 0;  // one after the other
  for (std::size_t k = 0; worth_sharing(left) && failing < 3; ++k) {
    const Diagonals along = diagonals(axes_.back(), k);
    for (std::size_t b = 0; b < at.size(); ++b) {
      at[b] = CenterBox::place(along, facets_.lifted({at_[b][0], at_[b][1], at_[b][2]}));
    }
    const RangeOf by_centers = [&](const SiteRange& own, const Position& low,
                                   const Position& high) {
      return Range(own, CenterBox(along, low, high));
    };
    const auto told_in_pass = [&](std::size_t now) { told(all - left + now); };
    const std::size_t inserted =
        pass(sites, left, {at, {0, 1, 2}, 0}, by_centers, told_in_pass).inserted;
    failing = inserted <= left / 8 ? failing + 1 : 0;  // also where a thread has nothing to do
    left -= inserted;
  }
  return left;
}

/// Whether little went in in all passes from this one on; of an earlier round, if there was one.
bool Shares::failing_from(std::size_t pass) const {
  return pass < kAxes && std::all_of(failing_.begin() + static_cast<std::ptrdiff_t>(pass),
                                     failing_.end(), std::identity());
}

bool Shares::worth_sharing(std::size_t count) const { return count / kWorthAThread >= own_.size(); }

/// Of so many sites that are left.
Inserter::Tally Shares::pass(SiteSet& sites, std::size_t left, const Cuts& cuts,
                             const RangeOf& range_of, const Told& told) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const std::size_t threads = own_.size();
  std::vector<Part> parts(threads);
  constexpr std::size_t kSamples = 2048;
  std::vector<Sample> samples = sampled(cuts.at, sites, left, kSamples * threads);
  // Three halvings take all axes, in whatever order: not in the middle each time.
  const Cutter cutter{cuts.axes, cuts.first};
  cutter.cut({{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}}, samples, parts, cuts.first);
  std::vector<std::size_t> todo(threads);
  parallel_each(threads, [&](std::size_t t) {
    const Part part = parts[t];
    std::size_t sum = 0;
    for (std::size_t b = 0; b < cuts.at.size(); ++b) {
      const std::uint8_t own = part.contains(cuts.at[b]) ? 1 : 0;
      own_[t][b + 1] = own;
      sum += own * sites.count_in(b);
    }
    todo[t] = sum;
    helpers_[t].move_to(range_of(SiteRange(own_[t]), part.low, part.high), sites);
  });
  facets_.share();
  Flag over;
  std::vector<Inserter::Tally> tallies(threads);
  parallel_each(threads, [&](std::size_t t) {
    const SetAtEnd at_end{over.set};
    tallies[t] = helpers_[t].insert_all(sites, [&, mine = todo[t]](std::size_t k) {
      if (facets_.full()) return false;
      if (over.set.load(std::memory_order_relaxed) && worth_sharing(mine - k)) return false;
      if (t == 0 && k % kTellEvery == 0) told(k);
      return true;
    });
  });
  facets_.unshare();
  for (const Inserter& helper : helpers_) inserter_.begin_at_last_of(helper);
  Inserter::Tally sum;
  for (const auto& tally : tallies) {
    sum.tried += tally.tried;
    sum.inserted += tally.inserted;
  }
  return sum;
}

}  // namespace tetsculpt::hull
