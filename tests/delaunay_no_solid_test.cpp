// Points that span no solid give no simplex, however many they are; one more point gives a solid.
#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "kernel/delaunay.h"
#include "kernel/distinct_points.h"
#include "tests/support/graph_oracles.h"

namespace tetsculpt {
namespace {

TEST_CASE("no simplex") {
  for (const auto& set : oracle::flat_sets()) {
    CAPTURE(set.name);
    const DistinctPoints distinct = distinct_points(set.points);
    const TetComplex complex = delaunay(distinct);
    CHECK(complex.tet_count() == 0);
    CHECK(complex.finite_tet_count() == 0);
    CHECK(complex.triangle_count() == 0);
    CHECK(complex.edge_count() == 0);
    CHECK_FALSE(broken_invariant(complex, distinct.points));
  }
}

TEST_CASE("a plane and one point off it: a pyramid over every triangle") {
  for (auto& set : oracle::flat_sets()) {
    double size = 1;
    for (const Point3& p : set.points) size = std::max({size, p.x, p.y, p.z});
    set.points.push_back({size, -11 * size, 7 * size});
    const DistinctPoints distinct = distinct_points(set.points);
    const TetComplex complex = delaunay(distinct);
    CAPTURE(set.name);
    CHECK(broken_invariant(complex, distinct.points).value_or("sound") == "sound");
    std::size_t without_apex = 0;
    const VertexId apex = distinct.vertex_of_input.back();
    for (std::uint32_t t = 0; t < complex.finite_tet_count(); ++t) {
      const auto& v = complex.vertices(TetId{t});
      without_apex += v[0] != apex && v[1] != apex && v[2] != apex && v[3] != apex;
    }
    CHECK(without_apex == 0);
  }
}

TEST_CASE("one tetrahedron") {
  const DistinctPoints distinct =
      distinct_points(std::vector<Point3>{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}});
  const TetComplex complex = delaunay(distinct);
  CHECK(complex.vertex_count() == 4);
  CHECK(complex.edge_count() == 6);
  CHECK(complex.triangle_count() == 4);
  CHECK(complex.finite_tet_count() == 1);
  CHECK(complex.tet_count() == 5);
  CHECK_FALSE(broken_invariant(complex, distinct.points));
}

}  // namespace
}  // namespace tetsculpt
