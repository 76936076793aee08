// The Gabriel graph, found from the links of edges, is that of all pairs against all points.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "kernel/delaunay.h"
#include "kernel/distinct_points.h"
#include "kernel/gabriel.h"
#include "tests/support/graph_oracles.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

std::set<oracle::Edge> kernel_graph(const DistinctPoints& distinct) {
  const TetComplex complex = delaunay(distinct);
  const Flags gabriel = gabriel_edges(distinct.points, complex);
  CHECK(gabriel.size() == complex.edge_count());
  return oracle::flagged_edges(complex, gabriel);
}

void check_graph(const std::vector<Point3>& input) {
  const DistinctPoints distinct = distinct_points(input);
  CHECK(kernel_graph(distinct) == oracle::gabriel_graph(distinct.points));
}

TEST_CASE("small solids") {
  for (const auto& set : oracle::small_solids()) {
    CAPTURE(set.name);
    check_graph(set.points);
  }
}

TEST_CASE("middling solids") {
  for (const auto& set : oracle::middling_solids()) {
    CAPTURE(set.name);
    check_graph(set.points);
  }
}

TEST_CASE("random lattices, where most spheres are touched") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    check_graph(point_sets::random_lattice(50, 4, seed));
  }
}

// The sphere of a square's diagonal passes through the other two corners. Outside is only the
// lexicographically greatest of all four, so neither diagonal has an empty sphere, though one of
// them is an edge of the complex.
TEST_CASE("the diagonals of a square") {
  const std::vector<Point3> points{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, 0.5, 9}};
  const DistinctPoints distinct = distinct_points(points);
  const auto graph = kernel_graph(distinct);
  const auto contains = [&](std::size_t i, std::size_t j) {
    const VertexId a = distinct.vertex_of_input[i];
    const VertexId b = distinct.vertex_of_input[j];
    return graph.contains({std::min(a, b), std::max(a, b)});
  };
  CHECK(contains(0, 1));
  CHECK(contains(0, 2));
  CHECK(contains(1, 3));
  CHECK(contains(2, 3));
  CHECK_FALSE(contains(0, 3));
  CHECK_FALSE(contains(1, 2));
}

TEST_CASE("any number of threads") {
  const DistinctPoints distinct = distinct_points(point_sets::bumpy_sphere(5000, 1));
  const TetComplex complex = delaunay(distinct);
  const Flags expected = gabriel_edges(distinct.points, complex);
  for (const int threads : {2, 3, 8}) {
    CAPTURE(threads);
    CHECK(gabriel_edges(distinct.points, complex, threads) == expected);
  }
  CHECK(gabriel_edges({}, TetComplex(), 4).empty());
}

}  // namespace
}  // namespace tetsculpt
