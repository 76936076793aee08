// No point is inside the perturbed sphere of a tetrahedron: all points against all tetrahedra.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/delaunay.h"
#include "kernel/distinct_points.h"
#include "kernel/perturbation.h"
#include "tests/support/graph_oracles.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

std::size_t points_inside(const std::vector<Point3>& points, const TetComplex& complex) {
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
