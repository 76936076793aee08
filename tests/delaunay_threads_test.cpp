// Hull and complex are bit for bit the same with any number of threads.
#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/delaunay.h"
#include "kernel/distinct_points.h"
#include "kernel/lifted_hull.h"
#include "kernel/tet_complex.h"
#include "tests/support/point_sets.h"
#include "tests/support/random_cases.h"

namespace tetsculpt {
namespace {

using point_sets::NamedPoints;

/// Pairs of skew lines: the tetrahedra are 58 times as many as the points, more than there is room
/// for while threads insert.
std::vector<Point3> crowded() {
  std::vector<Point3> points;
  for (int k = 0; k < 160; ++k) {
    const Point3 at{1.0 * (k % 5), 1.0 * (k / 5 % 5), 1.0 * (k / 25)};
    for (int i = 0; i < 60; ++i) {
      const double along = i / 256.0;
      points.push_back({at.x + along, at.y, at.z});
      points.push_back({at.x, at.y + along, at.z + 0.5});
    }
  }
  return points;
}

/// Large enough for the last rounds to be shared among threads, and on the bumpy sphere what is
/// left of the last one, too.
std::vector<NamedPoints> large_sets() {
  return {{"bumpy sphere, seed 2", point_sets::bumpy_sphere(60000, 2)},
          {"cube, seed 1", point_sets::uniform_cube(60000, 1)},
          {"torus, seed 3", point_sets::random_torus(30000, 3)},
          {"clusters, seed 4", point_sets::clusters(30000, 4)},
          {"lattice of side 40, seed 5", point_sets::random_lattice(50000, 40, 5)},
          {"grid of side 32", point_sets::grid(32)},
          {"19,776 points of a lattice sphere", point_sets::lattice_sphere(2500001)},
          {"160 pairs of skew lines", crowded()}};
}

/// How many tetrahedra, triangles and edges are not those of another complex; all, where their
/// number differs.
std::size_t differing_simplices(const TetComplex& a, const TetComplex& b) {
  if (a.finite_tet_count() != b.finite_tet_count() || a.tet_count() != b.tet_count() ||
      a.triangle_count() != b.triangle_count() || a.edge_count() != b.edge_count()) {
    return a.tet_count() + b.tet_count();
  }
  std::size_t differ = 0;
  for (std::uint32_t t = 0; t < a.tet_count(); ++t) {
    bool same = a.vertices(TetId{t}) == b.vertices(TetId{t});
    for (int i = 0; i < 4; ++i) {
      const Facet f = a.across(TetId{t}, i);
      const Facet g = b.across(TetId{t}, i);
      same &= f.tet == g.tet && f.corner == g.corner &&
              a.triangle(TetId{t}, i) == b.triangle(TetId{t}, i);
    }
    for (int k = 0; k < 6; ++k) same &= a.edge(TetId{t}, k) == b.edge(TetId{t}, k);
    differ += !same;
  }
  for (std::uint32_t t = 0; t < a.triangle_count(); ++t) {
    const Facet f = a.facet(TriangleId{t});
    const Facet g = b.facet(TriangleId{t});
    differ += f.tet != g.tet || f.corner != g.corner;
  }
  for (std::uint32_t e = 0; e < a.edge_count(); ++e) {
    differ += a.vertices(EdgeId{e}) != b.vertices(EdgeId{e}) ||
              a.triangle(EdgeId{e}) != b.triangle(EdgeId{e});
  }
  return differ;
}

TEST_CASE("the same tetrahedra, neighbours, triangles and edges in the same order") {
  for (const NamedPoints& set : testing::some_of(large_sets())) {
    CAPTURE(set.name);
    const DistinctPoints points = distinct_points(set.points);
    const TetComplex expected = delaunay(points);
    REQUIRE(expected.edge_count() > 0);
    for (const int threads : testing::some_of(std::vector{2, 3, 7})) {
      CAPTURE(threads);
      CHECK(differing_simplices(delaunay(points, {.threads = threads}), expected) == 0);
    }
  }
}

TEST_CASE("progress never falls, told by the caller's thread alone") {
  const LargeArray<Point3> points =
      distinct_points(point_sets::uniform_cube(testing::kSanitized ? 50000 : 200000, 6)).points;
  double last = 0;
  std::size_t falls = 0;
  std::size_t calls = 0;
  const auto progress = [&](double done) {
    falls += done < last;
    last = done;
    ++calls;
  };
  lifted_hull(points, {.threads = 2, .progress = progress});
  CHECK(falls == 0);
  CHECK(calls > 2);
  CHECK(last <= 1);
}

}  // namespace
}  // namespace tetsculpt
