// A walk four facets at a time goes on as long as one of four neighbours is nearer, and ends within
// the range. (tests/hull_region_test has what is seen.)
#include "kernel/hull_lanes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "kernel/distinct_points.h"
#include "tests/support/hull_regions.h"
#include "tests/support/point_sets.h"
#include "tests/support/site_blocks.h"

namespace tetsculpt::hull {
namespace {

struct Walks {
  std::size_t seen = 0, seen_beyond = 0, stuck = 0, at_border = 0, wrong = 0;
};

/// From every facet of the range towards the last site.
void walk_all(Facets& facets, Site apex, const SiteRange& own, Walks& walks) {
  const LiftedDifference q = facets.lifted(facets.point(apex));
  const auto in_range = [&](FacetIndex f) { return own.contains(facets.corners(f)); };
  for (FacetIndex f = 0; f < facets.size(); ++f) {
    if (!in_range(f) || facets.infinite(f)) continue;
    const auto [end, seen] = nearer_by_four(facets, f, q, own);
    const Facets::Height start = facets.height(f, q);
    const Facets::Height h = facets.height(end, q);
    if (seen) {
      // In the range, or right behind its border.
      const auto leads_in = [&](Ridge r) { return in_range(facet_of(r)); };
      walks.wrong += !in_range(end) && std::ranges::none_of(facets.neighbors(end), leads_in);
      walks.seen_beyond += !in_range(end);
      ++walks.seen;
      walks.wrong += !facets.visible(end, apex);
      continue;
    }
    walks.wrong += !in_range(end) || facets.infinite(end);
    walks.wrong += h.value < start.value - (start.error + h.error);
    // The highest neighbour is no higher, or not to be entered.
    double highest = -HUGE_VAL;
    bool closed = false;
    for (const Ridge r : facets.neighbors(end)) {
      const FacetIndex g = facet_of(r);
      const Facets::Height other = facets.height(g, q);
      highest = std::fmax(highest, other.value - 2 * other.error);
      closed = closed || !in_range(g) || facets.infinite(g);
    }
    walks.wrong += highest > h.value + 2 * h.error && !closed;
    (closed ? walks.at_border : walks.stuck) += 1;
  }
}

void check_walks(const std::vector<Point3>& set, std::size_t parts, Walks& walks) {
  const LargeArray<Point3> distinct = distinct_points(set).points;
  const std::vector<Point3> sites(distinct.begin(), distinct.end());
  hull_regions::Hull facets(sites);
  const auto apex = static_cast<Site>(sites.size() - 1);
  for (std::size_t part = 0; part < parts; ++part) {
    const auto begin = static_cast<Site>(sites.size() * part / parts);
    const auto end = static_cast<Site>(sites.size() * (part + 1) / parts);
    const hull_regions::SiteBlocks blocks = hull_regions::blocks_of(sites.size(), begin, end);
    walk_all(facets, apex, parts == 1 ? SiteRange{} : blocks.range(), walks);
  }
}

TEST_CASE("walks") {
  if (!has_four_lanes()) {
    MESSAGE("skipped: this processor takes one facet at a time");
    return;
  }
  Walks walks;
  for (const std::size_t parts : {1u, 3u}) {
    check_walks(point_sets::uniform_cube(400, 1), parts, walks);
    check_walks(point_sets::bumpy_sphere(400, 2), parts, walks);
    check_walks(point_sets::grid(6), parts, walks);
    check_walks(point_sets::lattice_sphere(1001), parts, walks);
  }
  CHECK(walks.wrong == 0);
  CHECK(walks.seen > 100);
  CHECK(walks.seen_beyond > 10);
  CHECK(walks.stuck > 100);
  CHECK(walks.at_border > 100);
}

}  // namespace
}  // namespace tetsculpt::hull
