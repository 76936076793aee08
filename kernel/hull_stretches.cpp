// How long a range takes depends on what else its processor does: in the same minutes, on a virtual
// machine, one of two halves of a million points took 430 to 690 ms, now the one and now the other.
// So threads stop when the first is done, where there is enough left to share. A thread takes its
// range in slices from all of its cells, so that what it leaves lies in all of them, and the next
// ranges have about as much of it each. (In the order of the curve, what it left lay in one corner:
// the next range that held it was that of one thread alone, or cut at its middle, where three
// quarters could not go in.)
//     Cuts along all three axes of a cube: on a bumpy sphere 25 % of the points do not go in in the
// first pass, 1.3 % in the second and 0.3 % in the third. (A torus is round: of the points around
// its hole, 36 % of all, none goes in as long as anything is cut.) To find that a point can't go in
// takes little, see Inserter::sees_beyond.
//     What is left comes last, on one thread, and a point takes three times as long there: its
// neighbourhood is in no cache. A thousand points per thread are worth another pass.
//     A bit per site instead of lists, a known facet per eight sites instead of each, and slices: a
// million points of a cube in 0.97 of the time, of a bumpy sphere in 0.98 (50 pairs). In 64 slices
// per cell 2 % more than before: half of a small piece lies next to what is in no cache any more.
#include "kernel/hull_stretches.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "kernel/parallel.h"

namespace tetsculpt::hull {
namespace {

/// Passes whose ranges have no border in common.
constexpr std::size_t kCycle = 3;
constexpr std::size_t kCellsPerThread = 4;
/// Sites that are worth a thread, or a piece of its own.
constexpr std::size_t kWorthAThread = 1024;
constexpr std::size_t kWorthAPiece = 256;
constexpr std::size_t kMostSlices = 8;  ///< per cell

/// Also where an exception ends what it is for.
struct SetAtEnd {
  std::atomic<bool>& flag;
  ~SetAtEnd() { flag = true; }
};

}  // namespace

Stretches::Stretches(Facets& facets, Inserter& inserter, std::size_t site_count)
    : facets_(facets), inserter_(inserter), site_count_(site_count) {}

void Stretches::insert(SiteSet& sites, std::size_t threads, const Told& told) {
  threads_ = threads;
  while (helpers_.size() < threads) helpers_.push_back(inserter_.helper());
  inserter_.mark_free();
  helpers_[0].take_over(inserter_);
  const std::size_t all = sites.count();
  passes_ = 0;
  for (std::size_t left = all; worth_sharing(left);) {
    slices_ = std::clamp<std::size_t>(left / (cells() * kWorthAPiece), 1, kMostSlices);
    pass(sites, [&](std::size_t tried) { told(all - left + tried); });
    const std::size_t before = std::exchange(left, sites.count());
    if (passes_ >= kCycle && left > before / 4 * 3) break;
  }
  for (Inserter& helper : helpers_) inserter_.take_over(helper);
}

bool Stretches::worth_sharing(std::size_t count) const { return count / kWorthAThread >= threads_; }

std::size_t Stretches::cells() const { return kCellsPerThread * threads_; }

/// Where a slice of the curve begins.
Site Stretches::cut(std::size_t slice) const {
  const std::size_t slices = cells() * slices_;
  if (slice == slices) return static_cast<Site>(site_count_);
  return static_cast<Site>(site_count_ * slice / slices / SiteSet::kPerWord * SiteSet::kPerWord);
}

/// Of two pairs of neighbouring cells. Slice by slice of all of them: what it leaves when it stops
/// lies in all four.
Stretches::Share Stretches::share_of(const std::array<std::size_t, 4>& cells) const {
  const auto begin = [&](std::size_t cell) { return cut(cell * slices_); };
  const auto end = [&](std::size_t cell) { return cut((cell + 1) * slices_); };
  Share share;
  share.range = {{begin(cells[0]), end(cells[1])}, {begin(cells[2]), end(cells[3])}};
  for (std::size_t slice = 0; slice < slices_; ++slice) {
    for (const std::size_t cell : cells) {
      share.pieces.push_back({cut(cell * slices_ + slice), cut(cell * slices_ + slice + 1)});
    }
  }
  return share;
}

/// Of equal cells of the curve. With two threads these are octants of a cube, as the curve has
/// them, four for each: 0 to 3, then 2 to 5, then 1, 2, 5 and 6, halves along one axis, along
/// another and along the third.
std::vector<Stretches::Share> Stretches::next_shares() {
  const std::size_t kind = passes_++ % kCycle;
  std::vector<Share> shares;
  for (std::size_t t = 0; t < threads_; ++t) {
    const std::size_t first = kind < 2 ? 4 * t + 2 * kind : 2 * t + 1;
    const std::size_t second = kind < 2 ? first + 2 : first + cells() / 2;
    shares.push_back(share_of({first % cells(), (first + 1) % cells(),  //
                               second % cells(), (second + 1) % cells()}));
  }
  return shares;
}

void Stretches::pass(SiteSet& sites, const Told& told) {
  constexpr std::size_t kTellEvery = 65536;
  const std::vector<Share> shares = next_shares();
  parallel_each(threads_, [&](std::size_t t) { helpers_[t].move_to(shares[t].range, sites); });
  facets_.share();
  std::atomic<bool> over = false;
  parallel_each(threads_, [&](std::size_t t) {
    const SetAtEnd at_end{over};
    Inserter& helper = helpers_[t];
    std::size_t left = 0;
    for (const Piece& piece : shares[t].pieces) left += sites.count(piece.begin, piece.end);
    std::size_t tried = 0;
    for (const Piece& piece : shares[t].pieces) {
      const bool whole = sites.each(piece.begin, piece.end, [&](Site s) {
        if (over.load(std::memory_order_relaxed) && worth_sharing(left - tried)) return false;
        if (helper.insert(s)) sites.erase(s);
        if (t == 0 && tried % kTellEvery == 0) told(tried);
        ++tried;
        return true;
      });
      if (!whole) return;
    }
  });
  facets_.unshare();
  for (const Inserter& helper : helpers_) inserter_.begin_at_last_of(helper);
}

}  // namespace tetsculpt::hull
