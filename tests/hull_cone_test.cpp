// A cone fills a cavity: each of its facets is linked to four others, back and forth, with whom it
// shares a ridge; small, and about as large as those that are linked by sorting.
#include "kernel/hull_cone.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/four_lanes.h"
#include "tests/support/hull_regions.h"
#include "tests/support/point_sets.h"

namespace tetsculpt::hull {
namespace {

/// The corners of a ridge, in ascending order.
std::array<Site, 3> corners_of(const Facets& facets, Ridge r) {
  std::array<Site, 3> corners{};
  for (std::uint32_t i = 0, k = 0; i < 4; ++i) {
    if (i != corner_of(r)) corners[k++] = facets.corners(facet_of(r))[i];
  }
  std::ranges::sort(corners);
  return corners;
}

/// How many links of a cone over what the last site sees are wrong. `visible` is how many facets
/// that is.
std::size_t wrong_links(const std::vector<Point3>& sites, bool by_four, std::size_t& visible) {
  hull_regions::Hull facets(sites);
  const auto apex = static_cast<Site>(sites.size() - 1);
  const hull_regions::Expected expected(facets, facets.size(), apex);
  Region region;
  REQUIRE(grow_region(facets, apex, expected.visible[0], {}, by_four, region));
  visible = region.visible.size();
  std::vector<Ridge> free(region.cut.size());
  const FacetIndex begin = facets.append(free.size()).begin;
  for (std::uint32_t k = 0; k < free.size(); ++k) free[k] = ridge(begin + k, 0);
  Cone cone(sites, facets, by_four);
  cone.put_up(apex, region, free);
  std::size_t wrong = cone.facets().size() != free.size();
  for (const ConeFacet& c : cone.facets()) {
    wrong += facets.corners(c.facet)[0] != apex;
    for (std::uint32_t i = 0; i < 4; ++i) {
      const Ridge other = facets.neighbors(c.facet)[i];
      const Ridge back = facets.neighbors(facet_of(other))[corner_of(other)];
      wrong += back != ridge(c.facet, i);
      wrong += corners_of(facets, other) != corners_of(facets, ridge(c.facet, i));
    }
  }
  return wrong;
}

TEST_CASE("cones in cavities of all sizes") {
  if (!has_four_lanes()) MESSAGE("four at a time skipped: this processor takes one");
  std::size_t wrong = 0, smallest = 1'000'000, largest = 0, about = 0;
  for (std::size_t n = 8; n < 196; n += n < 176 ? 28 : 1) {
    std::vector<Point3> sites = point_sets::bumpy_sphere(n, n);
    for (Point3& p : sites) {
      const double length = std::hypot(p.x, p.y, p.z);
      p = {p.x / length, p.y / length, p.z / length};
    }
    sites.push_back({0, 0, 0});  // sees all inside
    for (const bool by_four : {false, true}) {
      if (by_four && !has_four_lanes()) continue;
      std::size_t visible = 0;
      CAPTURE(n);
      wrong += wrong_links(sites, by_four, visible);
      smallest = std::min(smallest, visible);
      largest = std::max(largest, visible);
      about += visible > 500 && visible < 520;
    }
  }
  CHECK(wrong == 0);
  CHECK(smallest < 40);
  CHECK(largest > 520);
  CHECK(about > 4);
}

}  // namespace
}  // namespace tetsculpt::hull
