// The facets that a point sees, and the ridges around them, are those that an exact test of every
// facet finds, one facet at a time and four at a time; no mark is left.
#include "kernel/hull_region.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/four_lanes.h"
#include "kernel/lifted_hull.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

using hull::FacetIndex;
using hull::Facets;
using hull::Ridge;
using hull::Site;

/// The hull of all sites but the last, with infinity as the last corner of a facet.
void set_hull(Facets& facets, std::span<const Point3> sites) {
  const LiftedHull hull = lifted_hull(sites.first(sites.size() - 1));
  hull::FacetRoom room = facets.append(hull.tets.size());
  room.begin = static_cast<FacetIndex>(hull.tets.size());
  facets.give_back({room});
  // An even number of exchanges keeps the orientation.
  const auto turned = [&](std::size_t t) { return hull.tets[t][2] == kInfinite; };
  const auto corner = [&](std::size_t t, std::uint32_t i) { return turned(t) ? i ^ 1 : i; };
  for (FacetIndex t = 0; t < hull.tets.size(); ++t) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      const VertexId v = hull.tets[t][i];
      const FacetHandle h = hull.neighbors[t][i];
      facets.corners(t)[corner(t, i)] = v == kInfinite ? hull::kAtInfinity : static_cast<Site>(+v);
      facets.neighbors(t)[corner(t, i)] = hull::ridge(h / 4, corner(h / 4, h % 4));
    }
    facets.set_hyperplane(t);
  }
}

/// What a region should be, in ascending order.
struct Expected {
  std::vector<FacetIndex> visible;
  std::vector<Ridge> cut;

  Expected(const Facets& facets, std::size_t facet_count, Site apex) {
    for (FacetIndex f = 0; f < facet_count; ++f) {
      if (!facets.visible(f, apex)) continue;
      visible.push_back(f);
      for (std::uint32_t i = 0; i < 4; ++i) {
        const FacetIndex g = hull::facet_of(facets.neighbors(f)[i]);
        if (!facets.visible(g, apex)) cut.push_back(hull::ridge(f, i));
      }
    }
  }
};

std::vector<std::uint32_t> sorted(const hull::Stack<Ridge>& list) {
  std::vector<std::uint32_t> result(list.begin(), list.end());
  std::ranges::sort(result);
  return result;
}

std::size_t marked(Facets& facets, std::size_t facet_count) {
  std::size_t count = 0;
  for (FacetIndex f = 0; f < facet_count; ++f) count += facets.mark(f) != hull::Mark::kUnmet;
  return count;
}

/// How many facets were wrongly in, or not in, the region of the last site; grown from every facet
/// that it sees. Adds up what was unclear and hidden.
std::size_t wrong_regions(std::span<const Point3> sites, bool by_four, std::size_t& unclear) {
  Facets facets(sites, std::ldexp(1.0, *unit_exponent(sites, 10'000)));
  set_hull(facets, sites);
  const auto apex = static_cast<Site>(sites.size() - 1);
  const Expected expected(facets, facets.size(), apex);
  REQUIRE_FALSE(expected.visible.empty());
  hull::Region region;
  std::size_t wrong = 0;
  for (const FacetIndex seen : expected.visible) {
    REQUIRE(hull::grow_region(facets, apex, seen, {}, by_four, region));
    std::vector<std::uint32_t> visible = sorted(region.visible);
    for (std::uint32_t& r : visible) r = hull::facet_of(r);
    wrong += visible != expected.visible;
    wrong += sorted(region.cut) != expected.cut;
    unclear += region.unclear.size();
    region.unmark(facets);
    wrong += marked(facets, facets.size());
  }
  return wrong;
}

void check_regions(const std::vector<Point3>& set, bool ties) {
  if (!hull::has_four_lanes()) MESSAGE("four at a time skipped: this processor has no AVX2");
  const LargeArray<Point3> distinct = distinct_points(set).points;
  std::size_t wrong = 0, unclear = 0;
  for (std::size_t last = 0; last < distinct.size(); last += distinct.size() / 12) {
    std::vector<Point3> sites(distinct.begin(), distinct.end());
    std::rotate(sites.begin() + static_cast<std::ptrdiff_t>(last),
                sites.begin() + static_cast<std::ptrdiff_t>(last) + 1, sites.end());
    wrong += wrong_regions(sites, false, unclear);
    if (hull::has_four_lanes()) wrong += wrong_regions(sites, true, unclear);
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

/// Whether the region of the last site lies within the range, by the corners of what it sees.
bool within(const Facets& facets, const Expected& expected, const hull::SiteRange& own) {
  return std::ranges::all_of(expected.visible,
                             [&](FacetIndex f) { return own.contains(facets.corners(f)); });
}

TEST_CASE("ranges, and marks that others left beyond") {
  for (const std::vector<Point3>& set : {point_sets::uniform_cube(300, 2), point_sets::grid(5)}) {
    const LargeArray<Point3> sites = distinct_points(set).points;
    Facets facets(sites, std::ldexp(1.0, *unit_exponent(sites, 10'000)));
    set_hull(facets, sites);
    const auto apex = static_cast<Site>(sites.size() - 1);
    const Expected expected(facets, facets.size(), apex);
    std::size_t inside = 0, outside = 0;
    for (Site begin = 0; begin < apex; ++begin) {
      const hull::SiteRange own{begin, apex};
      for (const bool by_four : {false, true}) {
        if (by_four && !hull::has_four_lanes()) continue;
        hull::Region region;
        const bool grown =
            hull::grow_region(facets, apex, expected.visible[0], own, by_four, region);
        CHECK(grown == within(facets, expected, own));
        (grown ? inside : outside) += 1;
        region.unmark(facets);
        REQUIRE(marked(facets, facets.size()) == 0);
      }
    }
    CHECK(inside > 0);
    CHECK(outside > 0);
  }
}

TEST_CASE("what others have marked is not cut off") {
  const LargeArray<Point3> sites = distinct_points(point_sets::grid(5)).points;
  Facets facets(sites, std::ldexp(1.0, *unit_exponent(sites, 10'000)));
  set_hull(facets, sites);
  const auto apex = static_cast<Site>(sites.size() - 1);
  const Expected expected(facets, facets.size(), apex);
  hull::SiteRange own{apex - 1, apex};
  while (!within(facets, expected, own)) --own.begin;
  for (FacetIndex f = 0; f < facets.size(); ++f) {
    // No neighbour of what is this thread's.
    const auto is_own = [&](Ridge r) { return own.contains(facets.corners(hull::facet_of(r))); };
    if (own.contains(facets.corners(f)) || std::ranges::any_of(facets.neighbors(f), is_own))
      continue;
    facets.mark(f) = hull::Mark::kVisible;
  }
  const std::size_t of_others = marked(facets, facets.size());
  CHECK(of_others > 0);
  for (const bool by_four : {false, true}) {
    if (by_four && !hull::has_four_lanes()) continue;
    hull::Region region;
    REQUIRE(hull::grow_region(facets, apex, expected.visible[0], own, by_four, region));
    CHECK(sorted(region.cut) == expected.cut);
    region.unmark(facets);
    CHECK(marked(facets, facets.size()) == of_others);
  }
}

}  // namespace
}  // namespace tetsculpt
