// Ties among sites on a small lattice are decided by numbers in lexicographic order, and those of
// one sphere are known: as the tie rule says.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/hull_facets.h"
#include "kernel/perturbation.h"
#include "kernel/predicates.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

using hull::Site;
using point_sets::Random;

/// A sphere's lattice points, and some inside.
std::vector<Point3> sphere_and_grid() {
  return point_sets::joined(point_sets::lattice_sphere(5001), point_sets::grid(5));
}

/// Four sites that span a tetrahedron, positively oriented.
std::array<Site, 4> random_simplex(Random& random, const std::vector<Point3>& sites) {
  for (;;) {
    std::array<Site, 4> c{};
    for (Site& s : c) s = static_cast<Site>(random.below(sites.size()));
    const Sign side = orient3d(sites[c[0]], sites[c[1]], sites[c[2]], sites[c[3]]);
    if (side == Sign::kZero) continue;
    if (side == Sign::kNegative) std::swap(c[2], c[3]);
    return c;
  }
}

TEST_CASE("facets among cospherical sites see what is in the perturbed sphere") {
  constexpr std::uint64_t kSeed = 3;
  CAPTURE(kSeed);
  const std::size_t on_sphere = point_sets::lattice_sphere(5001).size();
  // The last two times 140 units long are within 2^16 and beyond.
  for (const double unit : {1.0, 0x1p-40, 460.0, 470.0}) {
    CAPTURE(unit);
    Random random(kSeed);
    const std::vector<Point3> sites = point_sets::scaled(sphere_and_grid(), unit);
    hull::Facets facets(sites, unit > 1 ? 1 : unit);
    facets.append(1);
    facets.remember_sphere({0, 1, 2, static_cast<Site>(on_sphere - 1)});
    CHECK(facets.on_sphere(0) == (unit != 470));
    std::size_t ties = 0;
    std::size_t inside = 0;
    std::size_t wrong = 0;
    for (int k = 0; k < 10000; ++k) {
      const std::array<Site, 4> c = random_simplex(random, sites);
      facets.corners(0) = c;
      const auto q = static_cast<Site>(random.below(sites.size()));
      if (std::ranges::find(c, q) != c.end()) continue;
      const bool expected =
          in_perturbed_sphere(sites[c[0]], sites[c[1]], sites[c[2]], sites[c[3]], sites[q]);
      wrong += facets.decide(0, q) != expected;
      ties += q < on_sphere && std::ranges::all_of(c, [&](Site s) { return s < on_sphere; });
      inside += expected;
    }
    CHECK(wrong == 0);
    CHECK(ties > 1000);
    CHECK(inside > 1000);
  }
}

TEST_CASE("which sites are on the sphere") {
  const std::vector<Point3> sites = sphere_and_grid();
  const std::size_t on_sphere = point_sets::lattice_sphere(5001).size();
  hull::Facets facets(sites, 1);
  facets.remember_sphere({0, 1, 2, static_cast<Site>(on_sphere - 1)});
  std::size_t wrong = 0;
  for (Site s = 0; s < sites.size(); ++s) wrong += facets.on_sphere(s) != (s < on_sphere);
  CHECK(wrong == 0);
  // Elsewhere it is not worth it.
  const std::vector<Point3> grid = point_sets::grid(10);
  hull::Facets none(grid, 1);
  none.remember_sphere({0, 1, 10, 100});
  CHECK_FALSE(none.on_sphere(0));
}

}  // namespace
}  // namespace tetsculpt
