// Boxes share out facets by the centers of their spheres; a region goes no farther than a box, and
// touches nothing beyond.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
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

/// Below and from `cut` on, along the first diagonal.
std::vector<CenterBox> halves(std::size_t first_diagonal, double cut) {
  return {{first_diagonal, {-kFar, -kFar, -kFar}, {cut, kFar, kFar}},
          {first_diagonal, {cut, -kFar, -kFar}, {kFar, kFar, kFar}}};
}

std::vector<std::vector<Point3>> sets() {
  return {point_sets::uniform_cube(400, 1), point_sets::random_torus(600, 2), point_sets::grid(6)};
}

TEST_CASE("a facet is in the box that holds its center, and in no other") {
  for (const std::vector<Point3>& set : sets()) {
    const LargeArray<Point3> sites = distinct_points(set).points;
    const hull_regions::Hull facets(sites);
    for (std::size_t first = 0; first < CenterBox::kDiagonals; ++first) {
      for (const double cut : {-0.5, 0.0, 0.25}) {
        CAPTURE(first);
        CAPTURE(cut);
        const std::vector<CenterBox> boxes = halves(first, cut);
        std::size_t wrong = 0;
        for (FacetIndex f = 0; f < facets.size(); ++f) {
          const Facet& facet = facets[f];
          const LiftedDifference center{facet.nx / 2, facet.ny / 2, facet.nz / 2, 0};
          const bool low = CenterBox::place(first, center)[0] < cut;
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
    for (std::size_t first = 0; first < CenterBox::kDiagonals; ++first) {
      const double at = CenterBox::place(first, facets.lifted(facets.point(apex)))[0];
      for (int step = -12; step <= 12; ++step) {
        const double cut = at + std::copysign(std::exp2(std::abs(step) - 8.0), step);
        for (const CenterBox& box : halves(first, cut)) {
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
