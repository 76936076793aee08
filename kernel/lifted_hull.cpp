// Quickhull (C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The Quickhull algorithm for convex hulls",
// ACM Transactions on Mathematical Software 22(4), 1996) on the lifted points and the point at
// infinity above them (K. Q. Brown, "Voronoi diagrams from convex hulls", Information Processing
// Letters 9(5), 1979). Each facet keeps the points that see it, farthest first; take a facet's
// farthest point, find the facets it sees and their horizon, put a cone over the horizon, hand the
// orphans on.
//
// Departures: the sets of points that see a facet hold one point at a time, neighbours on a Hilbert
// curve within rounds that take every sixteenth point first (kernel/insertion_order). It is never
// handed on, instead of 4 ln n times, and the facets in use stay in cache; its first facet is found
// by walking down the power of the facets' spheres, from where the last point went in. No point is
// ever discarded: all lifted points are extreme.
//
// What it brought, hull alone: one cache line per facet, hyperplane, corners and neighbours
// together, instead of five 15 %; stacks without checks 7 %, on cache lines of their own 4 %;
// rounds of seven times all before instead of once 25 %, of fifteen times 5 % (a round streams all
// facets through the cache); batches of 16 instead of whole rounds 25 %, of 2 instead of 16 another
// 7 %, of one 2 %;
// all four neighbours of a visible facet tested at once, also those that were tested from another
// one before: 84 tests a point of a cube instead of 48, but one loop without a branch on what they
// find, where waves of facets not met before took three each: 10 % (and those waves 12 and 5 %
// before); hyperplanes and spokes by four 5 % each, multiplications and additions in one 3 %; walks
// to the best of four neighbours instead of the first that is better a fifth (a million points of a
// torus); no SLP vectorizer (see cmake/targets.cmake) 14 %; hyperplanes that need no corner for a
// test, see kernel/hull_facets, and marks in an array of their own 6 %, of a million points 7 to
// 12 %; corners of a cone numbered by the visible facets met opposite them, whether they have a
// number or not, up to 4 %; large pages up to half, where small ones are dear, and small ones up to
// half, where large ones are (see kernel/large_array); the output gathered bucket by bucket and
// written once, where it was scattered, sorted and looked up again, 13 % of a million points of a
// cube; orders of four corners from a table 4 %, buckets sorted by counting 3 and 2 %, both four at
// a time 3 %; facets written to only when they are used 6 %; the cone put up straight from the
// ridges that are cut, numbers of corners in 32 bits, 5 %; points in large pages, too, 3 to 8 % at
// a million; rounds spaced evenly along the curve instead of by coins 2 to 5 %; a cone in two loops
// less 4 %, see kernel/hull_cone; walks to the best of four without branches on which 2 %; heights
// in fewer cycles, though not fewer instructions, and regions grown from far inside 3 %.
//     What an insertion takes is waiting more than work. A sixth more instructions where a region
// is grown cost it 1 %, twelve cycles more from one facet to the next 3 %: the six or seven steps
// from the first facet to the last wait for each other. A tenth fewer instructions where corners
// are numbered and cones linked brought 1 %.
//     Without gain: -march=native; facets that the next round's points will find asked for ahead,
// by what is known of their neighbours on the curve; visible facets listed one by one instead of
// four at a time (a quarter slower, because loads then meet stores that are not done); neighbours
// of visible facets asked for two facets ahead (2 to 7 % slower); corners numbered by the places
// they have in the cone, which spread the table of pairs over the nearest cache (4 % slower), by a
// hash table in that cache, or by the lesser of what is known and the count, where each number
// waits for the one before (9 % slower); spokes not kept but computed per facet (4 % slower); the
// error bound's square root by halving the exponent; output by lists per lowest corner, two passes
// less (half as slow again). With -O2 instead of -O3 a fifth is lost.
//
// Threads: vertices are numbered along a Hilbert curve, so a block of them is a small region. Each
// thread inserts the points of blocks on one side of a cut, see kernel/hull_shares. What would
// touch another's facets, 5 % of the points of a cube and 13 % of a bumpy sphere, where the
// tetrahedra inside have corners everywhere, comes after that, in regions with other borders.
// (Nearly all points of a sphere waited while walks stuck at the border of a range did not begin
// anew near the point.) Tried while they did: threads in step, each finds out what 16 of its points
// change and leaves marks without locks, then makes the changes that kept all marks. One in 5,000
// met another, but threads waited a fifth of the time for the one with the larger cavities, and
// what lies between the two halves costs the nearest cache: no faster than one thread on a sphere,
// slower on a cube. That a facet is in the range takes one corner to see, because the other three
// are its neighbour's, and what died is marked when somebody asks: in a range of all points an
// insertion takes 1 to 3 % longer than without one, where four corners and marks at once took 3 to
// 8. A facet that belongs to whom three of its corners are, instead of all four: 4 % fewer of a
// sphere's points wait, for a tenth more instructions.
//     Without gain at a million points: a thread that uses memory for the first time while rounds
// stay on another; the output's facets moved by whichever thread is free; threads kept from loop to
// loop, which spin for a while (65,536 points 5 %).
#include "kernel/lifted_hull.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/first_simplex.h"
#include "kernel/four_lanes.h"
#include "kernel/hull_facets.h"
#include "kernel/hull_inserter.h"
#include "kernel/hull_output.h"
#include "kernel/hull_shares.h"
#include "kernel/hull_sites.h"
#include "kernel/insertion_order.h"
#include "kernel/large_array.h"
#include "kernel/parallel.h"

namespace tetsculpt {
namespace {

using hull::facet_of;
using hull::FacetIndex;
using hull::FacetRoom;
using hull::Facets;
using hull::Inserter;
using hull::kAtInfinity;
using hull::ridge;
using hull::Site;

/// The tetrahedron and its four infinite facets, each made by putting infinity in a corner's place.
/// Returns facets to use next.
FacetRoom make_simplex(Facets& facets, const std::array<Site, 4>& simplex) {
  FacetRoom room = facets.append(5);
  room.begin += 5;
  facets.corners(0) = simplex;
  for (std::uint32_t i = 0; i < 4; ++i) {
    // Infinity in place of corner i, brought last. An odd number of exchanges in all: the shared
    // ridge turns around.
    auto& c = facets.corners(i + 1);
    c = simplex;
    c[i] = kAtInfinity;
    if (i == 3) {
      std::swap(c[0], c[1]);
    } else {
      std::swap(c[i], c[3]);
    }
  }
  // Five facets, each pair shares the ridge of its common corners.
  for (FacetIndex f = 0; f < 5; ++f) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      for (FacetIndex g = 0; g < 5; ++g) {
        for (std::uint32_t j = 0; j < 4 && g != f; ++j) {
          auto a = facets.corners(f);
          auto b = facets.corners(g);
          if (a[i] == b[j]) continue;
          a[i] = b[j] = 0;
          std::sort(a.begin(), a.end());
          std::sort(b.begin(), b.end());
          if (a == b) facets.neighbors(f)[i] = ridge(g, j);
        }
      }
    }
  }
  for (FacetIndex f = 0; f < 5; ++f) {
    facets.set_hyperplane(f);
  }
  return room;
}

/// Of which all coordinates are multiples; 0 where it is so small that it is of no use: the exact
/// stages without expansions take differences below 2^23 units.
double unit_of(std::span<const Point3> points, int threads) {
  constexpr int kMostBits = 48;
  const std::optional<int> exponent = unit_exponent(points, kMostBits, threads);
  return exponent ? std::ldexp(1.0, *exponent) : 0;
}

class Construction {
 public:
  Construction(std::span<const Point3> points, const std::array<Site, 4>& simplex,
               const LiftedHullOptions& options)
      : points_(points),
        simplex_(simplex),
        options_(options),
        facets_(points, unit_of(points, options.threads), options.threads),
        known_(options.threads > 1 ? (points.size() - 1) / hull::kGroup + 1 : 0, hull::kNone),
        by_four_(options.four_lanes && hull::has_four_lanes()),
        inserter_(points, facets_, {make_simplex(facets_, simplex)}, by_four_, known_) {
    if (options.threads > 1) shares_.emplace(points, facets_, inserter_, options.threads);
    facets_.remember_sphere(simplex);
  }

  void insert_all() {
    for (const InsertionRound& round : insertion_rounds(points_.size())) {
      // Of 14,000 points so many wait that two threads take as long as one.
      const std::size_t threads = worth_threads(round.size() / 2, options_.threads);
      if (threads == 1) {
        insert(round);
      } else {
        insert_in_parallel(round, threads);
      }
      done_ += round.size();
    }
  }

  LiftedHull result() {
    report(0);  // all are in: the rounds' sizes are in done_
    inserter_.give_back();
    shares_.reset();  // its tables' memory goes to the output
    std::function<void(double)> progress;
    if (options_.progress) {
      progress = [&](double share) { options_.progress(kInserting + (1 - kInserting) * share); };
    }
    return hull::output(facets_, points_.size(), options_.threads, by_four_, progress);
  }

 private:
  /// Of the work; the rest is output.
  static constexpr double kInserting = 0.85;

  /// Tells how many points of the round are in, if that is more than before. May throw, see
  /// LiftedHullOptions.
  void report(std::size_t in_round) {
    if (!options_.progress) return;
    told_ = std::max(told_, done_ + in_round);
    options_.progress(kInserting * static_cast<double>(told_) /
                      static_cast<double>(points_.size()));
  }

  void insert(const InsertionRound& round) {
    constexpr std::size_t kTellEvery = 65536;
    std::size_t k = 0;
    round.each(0, points_.size(), [&](std::size_t v) {
      if (in_simplex(static_cast<Site>(v))) return;
      [[maybe_unused]] const bool inserted = inserter_.insert(static_cast<Site>(v));
      assert(inserted);
      if (k++ % kTellEvery == 0) report(k);
    });
  }

  /// Of a torus, early rounds leave 16 facets per point, and the last one 20: half as many again.
  void reserve_for(const InsertionRound& round) {
    const std::size_t per_16 = 24 * (facets_.size() - inserter_.unused()) / done_ + 1;
    facets_.reserve(std::min(per_16 * ((done_ + round.size()) / 16 + 1), Facets::kMost));
  }

  void insert_in_parallel(const InsertionRound& round, std::size_t threads) {
    reserve_for(round);
    hull::SiteSet sites(points_.size());
    parallel_ranges(sites.block_count(), options_.threads, [&](std::size_t begin, std::size_t end) {
      const std::size_t end_site = std::min(end * hull::kBlock, points_.size());
      round.each(begin * hull::kBlock, end_site,
                 [&](std::size_t v) { sites.insert(static_cast<Site>(v)); });
    });
    for (const Site s : simplex_) sites.erase(s);
    shares_->insert(sites, threads, [&](std::size_t k) { report(k); });
  }

  bool in_simplex(Site s) const { return std::ranges::find(simplex_, s) != simplex_.end(); }

  std::span<const Point3> points_;
  std::array<Site, 4> simplex_;  ///< the first one, which is not inserted
  const LiftedHullOptions& options_;
  Facets facets_;
  std::vector<FacetIndex> known_;  ///< see Inserter
  bool by_four_;
  Inserter inserter_;
  std::optional<hull::Shares> shares_;  ///< with threads
  std::size_t done_ = 0;                ///< by whole rounds
  std::size_t told_ = 0;
};

}  // namespace

LiftedHull lifted_hull(std::span<const Point3> points, const LiftedHullOptions& options) {
  const FirstSimplex simplex = first_simplex(points);
  if (simplex.size < 4) return {};
  const LargeArrayReuse reuse;
  Construction construction(points, simplex.corners, options);
  construction.insert_all();
  return construction.result();
}

}  // namespace tetsculpt
