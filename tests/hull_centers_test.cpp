// Boxes share out facets by the centers of their spheres; a region goes no farther than a box, and
// touches nothing beyond.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/four_lanes.h"
#include "kernel/hull_range.h"
#include "kernel/hull_region.h"
#include "tests/support/hull_regions.h"
#include "tests/support/point_sets.h"
#include "tests/support/site_blocks.h"

namespace tetsculpt::hull {
namespace {

using hull_regions::Expected;
using hull_regions::marked;
using hull_regions::SiteBlocks;
using hull_regions::sorted;

constexpr double kFar = std::numeric_limits<double>::infinity();

constexpr std::size_t kTurns = 4;

/// Below and from `cut` on, along the first diagonal.
std::vector<CenterBox> halves(const Diagonals& along, double cut) {
  return {{along, {-kFar, -kFar, -kFar}, {cut, kFar, kFar}},
          {along, {cut, -kFar, -kFar}, {kFar, kFar, kFar}}};
}

std::vector<std::vector<Point3>> sets() {
  return {point_sets::uniform_cube(400, 1), point_sets::random_torus(600, 2), point_sets::grid(6)};
}

TEST_CASE("first diagonals are all four in turn, mirror images two by two") {
  const std::array<double, 3> p{0.5, 2, 8};  // each sum of theirs is another one
  for (std::size_t axis = 0; axis < 3; ++axis) {
    CAPTURE(axis);
    std::array<double, 3> mirrored = p;
    mirrored[axis] = -mirrored[axis];
    std::set<double> places;
    for (std::size_t turn = 0; turn < kTurns; ++turn) {
      CAPTURE(turn);
      const auto first = [&](const std::array<double, 3>& q, std::size_t of_turn) {
        const Diagonals along = diagonals(axis, of_turn);
        return CenterBox::place(along, {q[0], q[1], q[2], 0})[0];
      };
      places.insert(std::abs(first(p, turn)));
      CHECK(first(p, turn) == first(p, turn + kTurns));
      if (turn % 2 == 0) CHECK(std::abs(first(mirrored, turn)) == std::abs(first(p, turn + 1)));
    }
    CHECK(places.size() == kTurns);
  }
}

TEST_CASE("a facet is in the box that holds its center, and in no other") {
  for (const std::vector<Point3>& set : sets()) {
    const LargeArray<Point3> sites = distinct_points(set).points;
    const hull_regions::Hull facets(sites);
    for (std::size_t turn = 0; turn < kTurns; ++turn) {
      const Diagonals along = diagonals(2, turn);
      for (const double cut : {-0.5, 0.0, 0.25}) {
        CAPTURE(turn);
        CAPTURE(cut);
        const std::vector<CenterBox> boxes = halves(along, cut);
        std::size_t wrong = 0;
        for (FacetIndex f = 0; f < facets.size(); ++f) {
          const Facet& facet = facets[f];
          const LiftedDifference center{facet.nx / 2, facet.ny / 2, facet.nz / 2, 0};
          const bool low = CenterBox::place(along, center)[0] < cut;
          wrong += boxes[0].contains(facet) != low || boxes[1].contains(facet) == low;
        }
        CHECK(wrong == 0);
      }
    }
  }
}

struct Grown {
  std::size_t inside = 0, outside = 0;
};

/// Grows the region of an apex in a box, where everything outside of it is another thread's, which
/// has marked it.
void grow(Facets& facets, const Expected& expected, Site apex, const Range& own, Grown& count) {
  const auto owns = [&](FacetIndex f) { return own.owns(facets[f]); };
  const auto owns_around = [&](FacetIndex f) {
    return owns(f) &&
           std::ranges::all_of(facets.neighbors(f), [&](Ridge r) { return owns(facet_of(r)); });
  };
  for (FacetIndex f = 0; f < facets.size(); ++f) {
    facets.mark(f) = owns(f) ? Mark::kUnmet : Mark::kVisible;
  }
  const std::size_t of_others = marked(facets, facets.size());
  for (const bool by_four : {false, true}) {
    if (by_four && !has_four_lanes()) continue;
    Region region;
    const bool grown = grow_region(facets, apex, expected.visible[0], own, by_four, region);
    REQUIRE(grown == std::ranges::all_of(expected.visible, owns_around));
    if (grown) CHECK(sorted(region.cut) == expected.cut);
    (grown ? count.inside : count.outside) += 1;
    region.unmark(facets);
    std::size_t wrong = 0;
    for (FacetIndex f = 0; f < facets.size(); ++f) {
      wrong += (facets.mark(f) == Mark::kVisible) == owns(f);
    }
    CHECK(wrong == 0);
    CHECK(marked(facets, facets.size()) == of_others);
  }
}

TEST_CASE("a region is grown if it and its neighbours are in the box") {
  for (const std::vector<Point3>& set : sets()) {
    const LargeArray<Point3> sites = distinct_points(set).points;
    SiteBlocks blocks(sites.size());
    for (std::size_t b = 0; b < blocks.count(); ++b) blocks.take(b);
    hull_regions::Hull facets(sites);
    const auto apex = static_cast<Site>(sites.size() - 1);
    const Expected expected(facets, facets.size(), apex);
    Grown grown;
    for (std::size_t turn = 0; turn < kTurns; ++turn) {
      const Diagonals along = diagonals(2, turn);
      const double at = CenterBox::place(along, facets.lifted(facets.point(apex)))[0];
      for (int step = -12; step <= 12; ++step) {
        const double cut = at + std::copysign(std::exp2(std::abs(step) - 8.0), step);
        for (const CenterBox& box : halves(along, cut)) {
          grow(facets, expected, apex, Range(blocks.range(), box), grown);
        }
      }
    }
    CHECK(grown.inside > 0);
    CHECK(grown.outside > 0);
  }
}

}  // namespace
}  // namespace tetsculpt::hull
