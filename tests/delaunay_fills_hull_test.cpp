// The tetrahedra of an integer set fill its convex hull exactly once: their volumes, exact
// integers, add up to the hull's.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "kernel/delaunay.h"
#include "kernel/distinct_points.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

/// Six times the volume of abcd, positive where orient3d is. Exact on small integers.
double six_volumes(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const auto minus = [](const Point3& p, const Point3& q) {
    return Point3{p.x - q.x, p.y - q.y, p.z - q.z};
  };
  const Point3 u = minus(a, d);
  const Point3 v = minus(b, d);
  const Point3 w = minus(c, d);
  return u.x * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) +
         u.z * (v.x * w.y - v.y * w.x);
}

struct Volumes {
  double tets = 0;  ///< sum over the finite tetrahedra
  double hull = 0;  ///< sum of cones from the origin over the hull's triangles
};

Volumes volumes(const std::vector<Point3>& input) {
  const DistinctPoints distinct = distinct_points(input);
  const TetComplex complex = delaunay(distinct);
  Volumes sum;
  for (std::uint32_t t = 0; t < complex.tet_count(); ++t) {
    const auto& v = complex.vertices(TetId{t});
    std::array<Point3, 4> c{};
    for (std::size_t i = 0; i < 4; ++i) {
      if (v[i] != kInfinite) c[i] = distinct.points[+v[i]];
    }
    // An infinite tetrahedron faces outwards: with the origin as its apex it counts negatively.
    const double six = six_volumes(c[0], c[1], c[2], c[3]);
    if (complex.finite(TetId{t})) {
      CHECK(six > 0);
      sum.tets += six;
    } else {
      sum.hull -= six;
    }
  }
  return sum;
}

TEST_CASE("grids") {
  for (const std::size_t side : {2u, 3u, 4u, 5u, 9u, 12u}) {
    CAPTURE(side);
    const double cells = std::pow(static_cast<double>(side - 1), 3);
    const Volumes v = volumes(point_sets::grid(side));
    CHECK(v.tets == 6 * cells);
    CHECK(v.hull == 6 * cells);
  }
}

TEST_CASE("random lattices and lattice spheres") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const Volumes v = volumes(point_sets::random_lattice(300, 3 + seed, seed));
    CHECK(v.tets > 0);
    CHECK(v.tets == v.hull);
  }
  for (const long squared_radius : {1, 2, 3, 5, 6, 9, 14, 26, 101, 761, 1001}) {
    CAPTURE(squared_radius);
    const Volumes v = volumes(point_sets::lattice_sphere(squared_radius));
    CHECK(v.tets > 0);
    CHECK(v.tets == v.hull);
  }
}

TEST_CASE("skew lines: one tetrahedron per pair of segments") {
  const Volumes v = volumes(point_sets::skew_lines(40));
  CHECK(v.tets == 39.0 * 39.0 * 1000.0);
  CHECK(v.tets == v.hull);
}

}  // namespace
}  // namespace tetsculpt
