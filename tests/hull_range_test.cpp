// A region that would leave the range is not grown, and leaves no mark; what others have marked
// beyond the neighbours of the own facets does not matter.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/four_lanes.h"
#include "kernel/hull_region.h"
#include "tests/support/hull_regions.h"
#include "tests/support/point_sets.h"
#include "tests/support/site_blocks.h"

namespace tetsculpt::hull {
namespace {

using hull_regions::blocks_of;
using hull_regions::Expected;
using hull_regions::marked;
using hull_regions::SiteBlocks;
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

TEST_CASE("ranges that end with the curve") {
  for (const std::vector<Point3>& set : {point_sets::uniform_cube(500, 2), point_sets::grid(8)}) {
    const LargeArray<Point3> sites = distinct_points(set).points;
    hull_regions::Hull facets(sites);
    const auto apex = static_cast<Site>(sites.size() - 1);
    const Expected expected(facets, facets.size(), apex);
    Grown grown;
    for (Site begin = 0; begin < apex + kBlock; begin += kBlock) {
      grow(facets, expected, apex, blocks_of(sites.size(), begin, apex).range(), grown);
    }
    CHECK(grown.inside > 0);
    CHECK(grown.outside > 0);
  }
}

TEST_CASE("ranges of any blocks") {
  const LargeArray<Point3> sites = distinct_points(point_sets::uniform_cube(500, 2)).points;
  hull_regions::Hull facets(sites);
  const auto apex = static_cast<Site>(sites.size() - 1);
  const Expected expected(facets, facets.size(), apex);
  std::mt19937 random(3);
  Grown grown;
  for (int k = 0; k < 100; ++k) {
    SiteBlocks blocks(sites.size());
    std::vector<bool> taken(blocks.count());
    for (std::size_t b = 0; b < blocks.count(); ++b) {
      taken[b] = random() % 20 != 0;
      if (taken[b]) blocks.take(b);
    }
    const SiteRange own = blocks.range();
    REQUIRE(!own.all());
    REQUIRE(own.contains(kAtInfinity));
    for (Site s = 0; s <= apex; ++s) {
      REQUIRE(own.contains(s) == taken[s / kBlock]);
      const Site other = apex - s;
      const bool both = taken[s / kBlock] && taken[other / kBlock];
      REQUIRE(own.contains({s, s, other, s}) == both);
      REQUIRE(own.contains({other, s, s, kAtInfinity}) == both);
    }
    grow(facets, expected, apex, own, grown);
  }
  CHECK(SiteRange().contains({apex, 0, 1, kAtInfinity}));
  CHECK(grown.inside > 0);
  CHECK(grown.outside > 0);
}

TEST_CASE("what others have marked is not cut off") {
  const LargeArray<Point3> sites = distinct_points(point_sets::grid(8)).points;
  hull_regions::Hull facets(sites);
  const auto apex = static_cast<Site>(sites.size() - 1);
  const Expected expected(facets, facets.size(), apex);
  SiteBlocks blocks(sites.size());
  for (std::size_t b = blocks.count(); !within(facets, expected, blocks.range());) blocks.take(--b);
  const SiteRange own = blocks.range();
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
