#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/four_lanes.h"
#include "kernel/hull_cone_lanes.h"
#include "tests/support/point_sets.h"

/// Facets around an apex, as an insertion has them.
namespace tetsculpt::hull_cones {

using point_sets::Random;

/// Points of space, of a plane or of a small lattice, at several scales and places, none of them
/// equal to the first.
inline std::vector<Point3> random_sites(Random& random, std::size_t count) {
  const std::size_t kind = random.below(3);
  const double scale = std::ldexp(1.0, static_cast<int>(random.below(200)) - 100);
  const double away = random.below(2) == 0 ? 0 : 1000;
  std::vector<Point3> sites(count);
  for (Point3& p : sites) {
    const auto coordinate = [&] {
      return kind == 2 ? static_cast<double>(random.below(4)) : random.uniform(-1, 1);
    };
    do {
      p = {(coordinate() + away) * scale, coordinate() * scale,
           kind == 1 ? 0 : coordinate() * scale};
    } while (&p != &sites[0] && p == sites[0]);
  }
  return sites;
}

/// Facets with one apex and random other corners, some of them infinite, some flat or turned inside
/// out, with no hyperplane yet.
struct Scene {
  std::vector<Point3> sites;
  hull::Facets facets;
  std::vector<hull::ConeFacet> cone;  ///< and the first of them again, up to a multiple of four
  std::size_t size;
  std::vector<hull::Spoke> spokes;

  Scene(Random& random, std::size_t facet_count)
      : sites(random_sites(random, 3 * facet_count + 2)),
        facets(sites, std::ldexp(1.0, *unit_exponent(sites, 10'000))),
        size(facet_count) {
    facets.append(facet_count);
    for (std::uint32_t f = 0; f < facet_count; ++f) {
      auto& c = facets.corners(f);
      c = {0, 3 * f + 1, 3 * f + 2, random.below(4) == 0 ? hull::kAtInfinity : 3 * f + 3};
      for (std::uint32_t i = 1; i < 4; ++i) {
        spokes.push_back(c[i] == hull::kAtInfinity
                             ? facets.spoke_to_infinity()
                             : hull::lifted_difference(sites[c[i]], sites[0]));
      }
      cone.push_back({f, {12 * f, 12 * f + 4, 12 * f + 8}});
    }
    while (cone.size() % 4 != 0) cone.push_back(cone[cone.size() - size]);
  }

  std::span<const hull::ConeFacet> facets_to_set() const { return std::span(cone).first(size); }
  hull::LiftedDifference query() const { return facets.lifted(sites.back()); }

  std::vector<hull::Facets::Height> heights() const {
    std::vector<hull::Facets::Height> heights;
    for (const hull::ConeFacet& c : facets_to_set()) {
      heights.push_back(facets.height(c.facet, query()));
    }
    return heights;
  }
};

}  // namespace tetsculpt::hull_cones
