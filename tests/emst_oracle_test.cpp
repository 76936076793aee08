// The minimum spanning tree is that of the complete graph in the one order of edges.
#include <doctest/doctest.h>

#include <vector>

#include "kernel/delaunay.h"
#include "kernel/disjoint_sets.h"
#include "kernel/distinct_points.h"
#include "kernel/edge_order.h"
#include "kernel/emst.h"
#include "kernel/gabriel.h"
#include "tests/support/graph_oracles.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

void check_tree(const std::vector<Point3>& input) {
  const DistinctPoints distinct = distinct_points(input);
  const TetComplex complex = delaunay(distinct);
  const auto all = edges_by_length(distinct.points, complex, Flags(complex.edge_count(), 1));
  const std::vector<EdgeId> tree = emst(complex, all);
  CHECK(tree.size() + 1 == distinct.points.size());
  CHECK(oracle::edges_of(complex, tree) == oracle::emst(distinct.points));

  DisjointSets parts(complex.vertex_count());
  std::size_t cycles = 0;
  for (const EdgeId e : tree) {
    cycles += !parts.unite(+complex.vertices(e)[0], +complex.vertices(e)[1]);
  }
  CHECK(cycles == 0);

  const Flags gabriel = gabriel_edges(distinct.points, complex);
  CHECK(emst(complex, edges_by_length(distinct.points, complex, gabriel)) == tree);
}

TEST_CASE("small solids") {
  for (const auto& set : oracle::small_solids()) {
    CAPTURE(set.name);
    check_tree(set.points);
  }
}

TEST_CASE("middling solids") {
  for (const auto& set : oracle::middling_solids()) {
    CAPTURE(set.name);
    check_tree(set.points);
  }
}

TEST_CASE("random lattices, where most lengths tie") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    check_tree(point_sets::random_lattice(40, 5, seed));
  }
}

TEST_CASE("edges come shortest first") {
  const DistinctPoints distinct = distinct_points(point_sets::random_lattice(300, 8, 1));
  const TetComplex complex = delaunay(distinct);
  const auto tree =
      emst(complex, edges_by_length(distinct.points, complex, Flags(complex.edge_count(), 1)));
  std::size_t wrong = 0;
  for (std::size_t i = 1; i < tree.size(); ++i) {
    wrong +=
        !oracle::shorter(distinct.points, complex.vertices(tree[i - 1]), complex.vertices(tree[i]));
  }
  CHECK(wrong == 0);
}

TEST_CASE("no complex, no tree") { CHECK(emst(TetComplex(), {}).empty()); }

}  // namespace
}  // namespace tetsculpt
