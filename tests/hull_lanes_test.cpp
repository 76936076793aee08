// Four facets at a time give what one after the other gives, bit for bit: spokes, hyperplanes,
// their errors, what is seen and what is left open. (tests/hull_facets_height_test holds one
// against exact signs.)
#include "kernel/hull_lanes.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/lifted_hull.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

using point_sets::Random;

/// Points of space, of a plane or of a small lattice, at several scales and places.
std::vector<Point3> random_sites(Random& random, std::size_t count) {
  const std::size_t kind = random.below(3);
  const double scale = std::ldexp(1.0, static_cast<int>(random.below(200)) - 100);
  const double away = random.below(2) == 0 ? 0 : 1000;
  std::vector<Point3> sites(count);
  for (Point3& p : sites) {
    const auto coordinate = [&] {
      return kind == 2 ? static_cast<double>(random.below(4)) : random.uniform(-1, 1);
    };
    p = {(coordinate() + away) * scale, coordinate() * scale, kind == 1 ? 0 : coordinate() * scale};
  }
  return sites;
}

/// Facets of random corners, some of them infinite, some flat or turned inside out, with no
/// hyperplane yet; the last one's neighbours are four of the others.
struct Scene {
  std::vector<Point3> sites;
  hull::Facets facets;
  std::vector<hull::ConeFacet> cone;
  std::vector<hull::Spoke> spokes;

  Scene(Random& random, std::size_t facet_count)
      : sites(random_sites(random, 4 * facet_count + 1)),
        facets(sites, std::ldexp(1.0, unit_exponent(sites))) {
    std::vector<hull::FacetIndex> free;
    facets.append(facet_count, free);
    for (std::uint32_t f = 0; f < facet_count; ++f) {
      auto& c = facets.corners(f);
      c = {4 * f, 4 * f + 1, 4 * f + 2, random.below(4) == 0 ? hull::kAtInfinity : 4 * f + 3};
      for (std::uint32_t i = 1; i < 4; ++i) {
        spokes.push_back(hull::spoke(sites[4 * f + i], sites[4 * f]));
      }
      cone.push_back({f, {3 * f, 3 * f + 1, 3 * f + 2}});
      facets.mark(f) = 0;
      for (hull::Ridge& r : facets.neighbors(f)) {
        r = hull::ridge(static_cast<hull::FacetIndex>(random.below(facet_count)), 0);
      }
    }
  }

  const Point3& query() const { return sites.back(); }
};

std::vector<hull::Facet> facets_of(const Scene& scene) {
  std::vector<hull::Facet> facets;
  for (const hull::ConeFacet& c : scene.cone) facets.push_back(scene.facets[c.facet]);
  return facets;
}

/// Where the error has no bound, the normal means nothing.
bool same_bits(const std::vector<hull::Facet>& a, const std::vector<hull::Facet>& b) {
  for (std::size_t f = 0; f < a.size(); ++f) {
    if (a[f].error.bits() != b[f].error.bits()) return false;
    const std::array<double, 3> p{a[f].nx, a[f].ny, a[f].nz};
    const std::array<double, 3> q{b[f].nx, b[f].ny, b[f].nz};
    const bool bounded = std::isfinite(a[f].error.square());
    if (bounded && std::memcmp(&p, &q, sizeof p) != 0) return false;
  }
  return true;
}

TEST_CASE("hyperplanes and what a point sees") {
  if (!hull::has_four_lanes()) {
    MESSAGE("skipped: this processor takes one facet at a time");
    return;
  }
  Random random(11);
  std::size_t visible = 0, unclear = 0, hidden = 0, wrong_planes = 0, wrong_views = 0,
              wrong_heights = 0;
  for (int round = 0; round < 20'000; ++round) {
    Scene scene(random, 1 + random.below(9));
    hull::set_hyperplanes(scene.facets, scene.cone, scene.spokes);
    const std::vector<hull::Facet> expected = facets_of(scene);
    for (const hull::ConeFacet& c : scene.cone) scene.facets.set_hyperplane(c.facet, 1, 2, 3, {});
    hull::set_hyperplanes_by_four(scene.facets, scene.cone, scene.spokes);
    wrong_planes += !same_bits(facets_of(scene), expected);

    const hull::FacetIndex last = scene.cone.back().facet;
    std::vector<hull::FacetIndex> list;
    for (const hull::Ridge r : scene.facets.neighbors(last)) list.push_back(hull::facet_of(r));
    hull::Seen one{};
    hull::Seen four{};
    hull::see(scene.facets, list, scene.query(), &one);
    hull::see_by_four(scene.facets, list, scene.query(), &four);
    wrong_views += one.visible != four.visible || one.unclear != four.unclear;
    const auto heights = [&](auto&& of_neighbors) {
      return of_neighbors(scene.facets, last, scene.query());
    };
    const hull::NeighborHeights h1 = heights(hull::neighbor_heights);
    const hull::NeighborHeights h4 = heights(hull::neighbor_heights_by_four);
    wrong_heights += h1.visible != h4.visible;
    for (std::size_t i = 0; i < 4; ++i) {
      // Without a bound on the error, the height means nothing.
      if ((one.unclear >> i & 1) == 0) wrong_heights += h1.value[i] != h4.value[i];
    }
    for (int i = 0; i < 4; ++i) {
      visible += one.visible >> i & 1;
      unclear += one.unclear >> i & 1;
      hidden += ((one.visible | one.unclear) >> i & 1) == 0;
    }
  }
  CHECK(wrong_planes == 0);
  CHECK(wrong_views == 0);
  CHECK(wrong_heights == 0);
  CHECK(visible > 5'000);
  CHECK(unclear > 5'000);
  CHECK(hidden > 5'000);
}

TEST_CASE("spokes") {
  if (!hull::has_four_lanes()) {
    MESSAGE("skipped: this processor takes one facet at a time");
    return;
  }
  Random random(12);
  for (int round = 0; round < 1'000; ++round) {
    const std::vector<Point3> sites = random_sites(random, 1 + random.below(20));
    std::vector<hull::Site> corners(4 * (1 + random.below(3)));
    for (hull::Site& s : corners) s = static_cast<hull::Site>(random.below(sites.size()));
    const auto apex = static_cast<hull::Site>(random.below(sites.size()));
    std::vector<hull::Spoke> one(corners.size());
    std::vector<hull::Spoke> four(corners.size());
    hull::set_spokes(sites, apex, corners, one.data());
    hull::set_spokes_by_four(sites, apex, corners, four.data());
    REQUIRE(std::memcmp(one.data(), four.data(), one.size() * sizeof(hull::Spoke)) == 0);
  }
}

TEST_CASE("the same hull") {
  for (const std::vector<Point3>& set :
       {point_sets::uniform_cube(5000, 1), point_sets::bumpy_sphere(5000, 2),
        point_sets::random_lattice(3000, 12, 3), point_sets::grid(12),
        point_sets::clusters(3000, 4)}) {
    const LargeArray<Point3> points = distinct_points(set).points;
    const LiftedHull four = lifted_hull(points);
    const LiftedHull one = lifted_hull(points, {.four_lanes = false});
    CHECK(one.finite_count == four.finite_count);
    CHECK((one.tets == four.tets));
    CHECK((one.neighbors == four.neighbors));
  }
}

}  // namespace
}  // namespace tetsculpt
