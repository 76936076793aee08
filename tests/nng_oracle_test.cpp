// The nearest neighbour graph has, at each vertex, the first of all its edges in the one order.
#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "kernel/delaunay.h"
#include "kernel/distinct_points.h"
#include "kernel/edge_order.h"
#include "kernel/emst.h"
#include "kernel/gabriel.h"
#include "tests/support/graph_oracles.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

void check_graph(const std::vector<Point3>& input) {
  const DistinctPoints distinct = distinct_points(input);
  const TetComplex complex = delaunay(distinct);
  const auto all = edges_by_length(distinct.points, complex, Flags(complex.edge_count(), 1));
  const std::vector<EdgeId> graph = nearest_neighbor_graph(complex, all);
  const auto edges = oracle::edges_of(complex, graph);
  CHECK(edges.size() == graph.size());
  CHECK(edges == oracle::nearest_neighbor_graph(distinct.points));

  const Flags gabriel = gabriel_edges(distinct.points, complex);
  const auto of_gabriel =
      nearest_neighbor_graph(complex, edges_by_length(distinct.points, complex, gabriel));
  CHECK(oracle::edges_of(complex, of_gabriel) == edges);
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

TEST_CASE("random lattices, where most lengths tie") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    check_graph(point_sets::random_lattice(40, 5, seed));
  }
}

TEST_CASE("no complex, no graph") { CHECK(nearest_neighbor_graph(TetComplex(), {}).empty()); }

}  // namespace
}  // namespace tetsculpt
