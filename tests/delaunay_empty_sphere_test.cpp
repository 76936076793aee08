// No point is inside the perturbed sphere of a tetrahedron: all points against all tetrahedra.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "kernel/delaunay.h"
#include "kernel/distinct_points.h"
#include "kernel/perturbation.h"
#include "tests/support/graph_oracles.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

std::size_t points_inside(std::span<const Point3> points, const TetComplex& complex) {
  std::size_t inside = 0;
  for (std::uint32_t t = 0; t < complex.finite_tet_count(); ++t) {
    const auto& v = complex.vertices(TetId{t});
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      if (std::find(v.begin(), v.end(), VertexId{i}) != v.end()) continue;
      inside += in_perturbed_sphere(points[+v[0]], points[+v[1]], points[+v[2]], points[+v[3]],
                                    points[i]);
    }
  }
  return inside;
}

void check_empty_spheres(const std::vector<oracle::NamedPoints>& sets) {
  for (const auto& set : sets) {
    CAPTURE(set.name);
    const DistinctPoints distinct = distinct_points(set.points);
    const TetComplex complex = delaunay(distinct);
    CHECK(complex.vertex_count() == distinct.points.size());
    CHECK(broken_invariant(complex, distinct.points).value_or("sound") == "sound");
    CHECK(points_inside(distinct.points, complex) == 0);
  }
}

TEST_CASE("small solids") { check_empty_spheres(oracle::small_solids()); }

TEST_CASE("middling solids") { check_empty_spheres(oracle::middling_solids()); }

TEST_CASE("a sphere that most points are on, the others inside or outside") {
  std::vector<oracle::NamedPoints> sets;
  for (const long squared_radius : {41l, 101l, 194l}) {
    const auto sphere = point_sets::lattice_sphere(squared_radius);
    for (const std::size_t side : {2u, 4u}) {
      auto points = point_sets::joined(sphere, point_sets::random_lattice(60, side, 5));
      sets.push_back({"inside", points});
      for (int k = 0; k < 20; ++k) points.push_back({30.0 + k, k % 7 - 3.0, k % 3 - 1.0});
      sets.push_back({"both", points});
    }
  }
  check_empty_spheres(sets);
}

TEST_CASE("many small random lattices") {
  std::vector<oracle::NamedPoints> sets;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto points = point_sets::random_lattice(40 + seed, 3 + seed % 4, seed);
    sets.push_back({"seed " + std::to_string(seed), points});
  }
  check_empty_spheres(sets);
}

}  // namespace
}  // namespace tetsculpt
