// Large sets by the local criterion: across each facet the apex is outside the perturbed sphere,
// and the hull is convex at each of its edges. In a valid complex that is the whole property.
#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/delaunay.h"
#include "kernel/distinct_points.h"
#include "kernel/perturbation.h"
#include "kernel/predicates.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

/// The corners' points, the apex of the neighbour across facet i in place of infinity.
struct Facing {
  std::array<Point3, 4> corners;
  Point3 apex;
};

Facing facing(std::span<const Point3> points, const TetComplex& complex, TetId t, int i) {
  const Facet other = complex.across(t, i);
  const VertexId apex = complex.vertices(other.tet)[static_cast<std::size_t>(other.corner)];
  Facing f{{}, points[+apex]};
  for (std::size_t k = 0; k < 4; ++k) {
    const VertexId v = complex.vertices(t)[k];
    f.corners[k] = v == kInfinite ? f.apex : points[+v];
  }
  return f;
}

std::size_t bad_facets(std::span<const Point3> points, const TetComplex& complex) {
  std::size_t bad = 0;
  for (std::uint32_t t = 0; t < complex.tet_count(); ++t) {
    const bool finite = complex.finite(TetId{t});
    for (int i = 0; i < 4; ++i) {
      if (complex.finite(complex.neighbor(TetId{t}, i)) != finite) continue;
      const auto [c, apex] = facing(points, complex, TetId{t}, i);
      bad += finite ? in_perturbed_sphere(c[0], c[1], c[2], c[3], apex)
                    : orient3d(c[0], c[1], c[2], c[3]) == Sign::kPositive;
    }
  }
  return bad;
}

void check_delaunay(const std::vector<Point3>& input) {
  const DistinctPoints distinct = distinct_points(input);
  const TetComplex complex = delaunay(distinct);
  CHECK(complex.vertex_count() == distinct.points.size());
  CHECK(broken_invariant(complex, distinct.points).value_or("sound") == "sound");
  CHECK(bad_facets(distinct.points, complex) == 0);
}

TEST_CASE("20000 points on a bumpy sphere") { check_delaunay(point_sets::bumpy_sphere(20000, 1)); }

TEST_CASE("10000 uniform points") { check_delaunay(point_sets::uniform_cube(10000, 2)); }

TEST_CASE("10000 uniform points, far off") {
  check_delaunay(point_sets::translated(point_sets::uniform_cube(10000, 3), {5e5, 5.4e6, 100}));
}

TEST_CASE("3000 points in clusters") { check_delaunay(point_sets::clusters(3000, 4)); }

TEST_CASE("a grid of 4096, exact and with rounded coordinates") {
  check_delaunay(point_sets::grid(16));
  check_delaunay(point_sets::grid(16, 0.1));
}

TEST_CASE("skew lines: 40000 tetrahedra") { check_delaunay(point_sets::skew_lines(200)); }

// Whichever point of the inner ones comes first sees every facet: a cone over the whole hull.
TEST_CASE("points at the centre of a large empty sphere") {
  const auto inner = point_sets::scaled(point_sets::uniform_cube(20, 5), 1e-3);
  check_delaunay(point_sets::joined(point_sets::sphere(0.06, 6), inner));
  check_delaunay(point_sets::joined(point_sets::lattice_sphere(5001), inner));
}

TEST_CASE("a dense plane, its mirror image, and one point between") {
  auto points = point_sets::plane_and_apex(2000, 7);
  for (std::size_t i = 0; i < 2000; ++i) points.push_back({points[i].x, points[i].y, 2});
  check_delaunay(points);
}

}  // namespace
}  // namespace tetsculpt
