// The facets that a point sees, and the ridges around them, are those that an exact test of every
// facet finds, one facet at a time and four at a time; no mark is left.
#include "kernel/hull_region.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/four_lanes.h"
#include "tests/support/hull_regions.h"
#include "tests/support/point_sets.h"

namespace tetsculpt::hull {
namespace {

using hull_regions::Expected;
using hull_regions::marked;
using hull_regions::sorted;

/// How many facets were wrongly in, or not in, the region of the last site; grown from every facet
/// that it sees. Adds up what was unclear and hidden.
std::size_t wrong_regions(std::span<const Point3> sites, bool by_four, std::size_t& unclear) {
  hull_regions::Hull facets(sites);
  const auto apex = static_cast<Site>(sites.size() - 1);
  const Expected expected(facets, facets.size(), apex);
  REQUIRE_FALSE(expected.visible.empty());
  Region region;
  std::size_t wrong = 0;
  for (const FacetIndex seen : expected.visible) {
    REQUIRE(grow_region(facets, apex, seen, {}, by_four, region));
    std::vector<std::uint32_t> visible = sorted(region.visible);
    for (std::uint32_t& r : visible) r = facet_of(r);
    wrong += visible != expected.visible;
    wrong += sorted(region.cut) != expected.cut;
    unclear += region.unclear.size();
    region.unmark(facets);
    wrong += marked(facets, facets.size());
  }
  return wrong;
}

void check_regions(const std::vector<Point3>& set, bool ties) {
  if (!has_four_lanes()) MESSAGE("four at a time skipped: this processor takes one");
  const LargeArray<Point3> distinct = distinct_points(set).points;
  std::size_t wrong = 0, unclear = 0;
  for (std::size_t last = 0; last < distinct.size(); last += distinct.size() / 12) {
    std::vector<Point3> sites(distinct.begin(), distinct.end());
    std::rotate(sites.begin() + static_cast<std::ptrdiff_t>(last),
                sites.begin() + static_cast<std::ptrdiff_t>(last) + 1, sites.end());
    wrong += wrong_regions(sites, false, unclear);
    if (has_four_lanes()) wrong += wrong_regions(sites, true, unclear);
  }
  CHECK(wrong == 0);
  CHECK((unclear > 0) == ties);
}

TEST_CASE("points of a volume") { check_regions(point_sets::uniform_cube(400, 1), false); }
TEST_CASE("points of a grid") { check_regions(point_sets::grid(6), true); }
TEST_CASE("cospherical points") { check_regions(point_sets::lattice_sphere(1001), true); }
TEST_CASE("a large cavity") {
  // All see all that is around the middle of a sphere.
  std::vector<Point3> points = point_sets::bumpy_sphere(600, 3);
  points.push_back({0, 0, 0});
  check_regions(points, false);
}

}  // namespace
}  // namespace tetsculpt::hull
