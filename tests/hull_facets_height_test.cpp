// A height that is larger than its error has the right sign, whether hyperplanes are set one or
// four at a time, and visibility is exact, on queries far off, near and on the sphere.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/four_lanes.h"
#include "kernel/hull_cone_lanes.h"
#include "kernel/hull_facets.h"
#include "tests/support/exact_predicates.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

using point_sets::Random;

/// A tetrahedron and a query.
using Scene = std::array<Point3, 5>;

Point3 random_point(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

/// A point of the unit sphere, up to rounding.
Point3 on_sphere(Random& random) {
  for (;;) {
    const Point3 p = random_point(random);
    const double r = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    if (r > 0.1) return {p.x / r, p.y / r, p.z / r};
  }
}

Point3 on_lattice(Random& random, std::size_t side) {
  const auto coordinate = [&] { return static_cast<double>(random.below(side)); };
  return {coordinate(), coordinate(), coordinate()};
}

/// Off by up to 2^-k, where k is anything up to the last bit.
Point3 displaced(const Point3& p, Random& random) {
  const double by = std::ldexp(1.0, -static_cast<int>(random.below(55)));
  const Point3 d = random_point(random);
  return {p.x + by * d.x, p.y + by * d.y, p.z + by * d.z};
}

/// a + s (b - a) + t (c - a), rounded.
Point3 combined(const Point3& a, const Point3& b, double s, const Point3& c, double t) {
  return {a.x + s * (b.x - a.x) + t * (c.x - a.x), a.y + s * (b.y - a.y) + t * (c.y - a.y),
          a.z + s * (b.z - a.z) + t * (c.z - a.z)};
}

/// Anything, one sphere up to rounding, small and large lattices, three on about a line, four in
/// about a plane; in a third of all cases the query is about a corner. At several scales and
/// places.
Scene random_scene(Random& random) {
  Scene scene;
  const std::size_t kind = random.below(7);
  for (Point3& p : scene) {
    p = kind == 1   ? on_sphere(random)
        : kind == 2 ? on_lattice(random, 3)
        : kind == 3 ? on_lattice(random, 100)
        : kind == 4 ? on_lattice(random, 100'000)
                    : random_point(random);
  }
  const double s = random.uniform(-2, 2);
  const double t = random.uniform(-2, 2);
  if (kind == 5) scene[2] = displaced(combined(scene[0], scene[1], s, scene[0], 0), random);
  if (kind == 6) scene[3] = displaced(combined(scene[0], scene[1], s, scene[2], t), random);
  if (random.below(3) == 0) scene[4] = displaced(scene[random.below(4)], random);
  if (random.below(4) == 0) scene[4].x *= 1e6;
  const double scale = std::ldexp(1.0, static_cast<int>(random.below(250)) - 130);
  const double away = random.below(2) == 0 ? 0 : 1000;
  for (Point3& p : scene) p = {(p.x + away) * scale, p.y * scale, p.z * scale};
  return scene;
}

/// The scene and, in half of all cases, a site so far off that it is a speck in the set.
std::vector<Point3> sites_of(Random& random, const Scene& scene) {
  std::vector<Point3> sites(scene.begin(), scene.end());
  if (random.below(2) == 0) {
    const double away = std::ldexp(1.0, static_cast<int>(random.below(20)));
    sites.push_back({scene[0].x + away * (scene[1].x - scene[0].x), scene[0].y,
                     scene[0].z + away * (scene[2].z - scene[0].z)});
  }
  return sites;
}

/// How often a height's sign was right, open or wrong.
struct Tally {
  std::int64_t clear = 0, unclear = 0, wrong = 0;
  void count(hull::Facets::Height h, Sign exact) {
    if (std::fabs(h.value) > h.error) {
      ++clear;
      wrong += sign_of(h.value) != exact;
    } else {
      ++unclear;
    }
  }
};

/// Sets the hyperplane of a facet again, four at a time, where that can be done.
void set_by_four(hull::Facets& facets, hull::FacetIndex f) {
  if (!hull::has_four_lanes()) return;
  const auto& c = facets.corners(f);
  std::vector<hull::Spoke> spokes;
  for (std::size_t i = 1; i < 4; ++i) {
    spokes.push_back(c[i] == hull::kAtInfinity
                         ? facets.spoke_to_infinity()
                         : hull::lifted_difference(facets.point(c[i]), facets.point(c[0])));
  }
  std::array<hull::ConeFacet, 4> cone;
  cone.fill({f, {0, 4, 8}});
  hull::finish_cone_by_four(facets, c[0], std::span(cone).first(1), spokes.data(), {});
}

TEST_CASE("heights and their errors against exact signs") {
  Random random(3);
  Tally finite, infinite;
  std::int64_t ties = 0, wrong = 0;
  for (int round = 0; round < 60'000; ++round) {
    Scene p = random_scene(random);
    const Sign volume = exact::orient3d(p[0], p[1], p[2], p[3]);
    if (volume == Sign::kZero) continue;
    if (volume == Sign::kNegative) std::swap(p[0], p[1]);
    const std::vector<Point3> sites = sites_of(random, p);
    hull::Facets facets(sites, std::ldexp(1.0, *unit_exponent(sites, 10'000)));
    facets.append(2);
    const hull::FacetIndex f = 0;
    facets.corners(f) = {0, 1, 2, 3};
    facets.set_hyperplane(f);
    const Sign exact = exact::insphere(p[0], p[1], p[2], p[3], p[4]);
    finite.count(facets.height(f, facets.lifted(p[4])), exact);
    set_by_four(facets, f);
    finite.count(facets.height(f, facets.lifted(p[4])), exact);
    ties += exact == Sign::kZero;

    // Beyond the triangle 0 1 2, as seen from 3.
    const hull::FacetIndex g = 1;
    facets.corners(g) = {1, 0, 2, hull::kAtInfinity};
    facets.set_hyperplane(g);
    const Sign beyond = -exact::orient3d(p[0], p[1], p[2], p[4]);
    infinite.count(facets.height(g, facets.lifted(p[4])), beyond);
    set_by_four(facets, g);
    infinite.count(facets.height(g, facets.lifted(p[4])), beyond);

    bool corner = false;
    for (std::size_t i = 0; i < 4; ++i) corner = corner || p[i] == p[4];
    if (corner) continue;  // no point is given twice
    const bool inside = exact::in_perturbed_sphere(p[0], p[1], p[2], p[3], p[4]).inside;
    wrong += facets.visible(f, 4) != inside;
  }
  CHECK(wrong == 0);
  CHECK(finite.wrong == 0);
  CHECK(finite.clear > 40'000);
  CHECK(finite.unclear > 10'000);
  CHECK(infinite.wrong == 0);
  CHECK(infinite.clear > 40'000);
  CHECK(infinite.unclear > 2'000);
  CHECK(ties > 1'000);
}

}  // namespace
}  // namespace tetsculpt
