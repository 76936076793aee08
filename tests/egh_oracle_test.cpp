// The extended Gabriel hypergraph, found from the complex, is that of all pairs of Gabriel edges
// against all points.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <set>
#include <vector>

#include "kernel/delaunay.h"
#include "kernel/distinct_points.h"
#include "kernel/egh.h"
#include "kernel/gabriel.h"
#include "tests/support/graph_oracles.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

std::set<oracle::Triangle> flagged_triangles(const TetComplex& complex, const Flags& flags) {
  std::set<oracle::Triangle> result;
  for (std::uint32_t t = 0; t < complex.triangle_count(); ++t) {
    if (!flags[t]) continue;
    auto corners = complex.vertices(TriangleId{t});
    std::sort(corners.begin(), corners.end());
    result.insert(corners);
  }
  return result;
}

void check_hypergraph(const std::vector<Point3>& input) {
  const DistinctPoints distinct = distinct_points(input);
  const TetComplex complex = delaunay(distinct);
  const Egh egh = extended_gabriel_hypergraph(distinct.points, complex,
                                              gabriel_edges(distinct.points, complex));
  REQUIRE(egh.edges.size() == complex.edge_count());
  REQUIRE(egh.triangles.size() == complex.triangle_count());

  const auto edges = oracle::egh_edges(distinct.points);
  CHECK(oracle::flagged_edges(complex, egh.edges) == edges);
  const auto cycles = oracle::three_cycles(edges, distinct.points.size());
  const auto of_complex = oracle::triangles(complex);
  std::set<oracle::Triangle> triangles;
  std::set_intersection(cycles.begin(), cycles.end(), of_complex.begin(), of_complex.end(),
                        std::inserter(triangles, triangles.end()));
  CHECK(flagged_triangles(complex, egh.triangles) == triangles);
}

TEST_CASE("small solids") {
  for (const auto& set : oracle::small_solids()) {
    CAPTURE(set.name);
    check_hypergraph(set.points);
  }
}

TEST_CASE("middling solids") {
  for (const auto& set : oracle::middling_solids()) {
    CAPTURE(set.name);
    check_hypergraph(set.points);
  }
}

TEST_CASE("random lattices, where most spheres are touched") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    check_hypergraph(point_sets::random_lattice(50, 4, seed));
  }
}

// The apex is over the corner of an obtuse triangle: the long edge is no Gabriel edge, but the
// triangle's sphere is empty.
TEST_CASE("an edge that completes a triangle") {
  const std::vector<Point3> points{{-2, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, -9, 9}};
  const DistinctPoints distinct = distinct_points(points);
  const TetComplex complex = delaunay(distinct);
  const Flags gabriel = gabriel_edges(distinct.points, complex);
  const Egh egh = extended_gabriel_hypergraph(distinct.points, complex, gabriel);
  const VertexId a = distinct.vertex_of_input[0];
  const VertexId b = distinct.vertex_of_input[1];
  const oracle::Edge longest{std::min(a, b), std::max(a, b)};
  CHECK_FALSE(oracle::flagged_edges(complex, gabriel).contains(longest));
  CHECK(oracle::flagged_edges(complex, egh.edges).contains(longest));
}

TEST_CASE("no complex, no hypergraph") {
  const Egh egh = extended_gabriel_hypergraph({}, TetComplex(), {});
  CHECK(egh.edges.empty());
  CHECK(egh.triangles.empty());
}

}  // namespace
}  // namespace tetsculpt
