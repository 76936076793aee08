// A region that would leave the range is not grown, and leaves no mark; what others have marked
// beyond the neighbours of the own facets does not matter.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/four_lanes.h"
#include "kernel/hull_region.h"
#include "tests/support/hull_regions.h"
#include "tests/support/point_sets.h"

namespace tetsculpt::hull {
namespace {

using hull_regions::Expected;
using hull_regions::marked;
using hull_regions::sorted;

/// Whether the region of the last site lies within the range, by the corners of what it sees.
bool within(const Facets& facets, const Expected& expected, const SiteRange& own) {
  return std::ranges::all_of(expected.visible,
                             [&](FacetIndex f) { return own.contains(facets.corners(f)); });
}

struct Grown {
  std::size_t inside = 0, outside = 0;
};

/// Checks that the region of an apex is grown if it is within the range, and leaves no mark.
void grow(Facets& facets, const Expected& expected, Site apex, const SiteRange& own, Grown& count) {
  for (const bool by_four : {false, true}) {
    if (by_four && !has_four_lanes()) continue;
    Region region;
    const bool grown = grow_region(facets, apex, expected.visible[0], own, by_four, region);
    CHECK(grown == within(facets, expected, own));
    (grown ? count.inside : count.outside) += 1;
    region.unmark(facets);
    REQUIRE(marked(facets, facets.size()) == 0);
  }
}

TEST_CASE("ranges, and marks that others left beyond") {
  for (const std::vector<Point3>& set : {point_sets::uniform_cube(300, 2), point_sets::grid(5)}) {
    const LargeArray<Point3> sites = distinct_points(set).points;
    hull_regions::Hull facets(sites);
    const auto apex = static_cast<Site>(sites.size() - 1);
    const Expected expected(facets, facets.size(), apex);
    Grown grown;
    for (Site begin = 0; begin < apex; ++begin) {
      const SiteRange own{{begin, apex}};
      grow(facets, expected, apex, own, grown);
    }
    CHECK(grown.inside > 0);
    CHECK(grown.outside > 0);
  }
}

TEST_CASE("ranges of two arcs") {
  const LargeArray<Point3> sites = distinct_points(point_sets::uniform_cube(300, 2)).points;
  hull_regions::Hull facets(sites);
  const auto apex = static_cast<Site>(sites.size() - 1);
  const Expected expected(facets, facets.size(), apex);
  Grown grown;
  for (Site gap = 1; gap < apex - 4; ++gap) {
    // All but a gap in the middle, the second arc beyond the curve's end.
    const Site begin = (apex - gap) / 2;
    const SiteRange own{{begin / 2, begin}, {begin + gap, begin / 2}};
    for (Site s = 0; s <= apex; ++s) {
      const bool in_gap = s >= begin && s < begin + gap;
      REQUIRE(own.contains(s) == !in_gap);
      REQUIRE(own.contains({s, begin / 2, kAtInfinity, begin + gap}) == !in_gap);
    }
    grow(facets, expected, apex, own, grown);
  }
  CHECK(grown.inside > 0);
  CHECK(grown.outside > 0);
}

TEST_CASE("what others have marked is not cut off") {
  const LargeArray<Point3> sites = distinct_points(point_sets::grid(5)).points;
  hull_regions::Hull facets(sites);
  const auto apex = static_cast<Site>(sites.size() - 1);
  const Expected expected(facets, facets.size(), apex);
  SiteRange own{{apex - 1, apex}};
  while (!within(facets, expected, own)) --own.first.begin;
  for (FacetIndex f = 0; f < facets.size(); ++f) {
    // No neighbour of what is this thread's.
    const auto is_own = [&](Ridge r) { return own.contains(facets.corners(facet_of(r))); };
    if (own.contains(facets.corners(f)) || std::ranges::any_of(facets.neighbors(f), is_own))
      continue;
    facets.mark(f) = Mark::kVisible;
  }
  const std::size_t of_others = marked(facets, facets.size());
  CHECK(of_others > 0);
  for (const bool by_four : {false, true}) {
    if (by_four && !has_four_lanes()) continue;
    Region region;
    REQUIRE(grow_region(facets, apex, expected.visible[0], own, by_four, region));
    CHECK(sorted(region.cut) == expected.cut);
    region.unmark(facets);
    CHECK(marked(facets, facets.size()) == of_others);
  }
}

}  // namespace
}  // namespace tetsculpt::hull
