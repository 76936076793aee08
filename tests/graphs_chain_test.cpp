// NNG in EMST in Gabriel graph in EGH in the Delaunay complex, on everything.
#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "kernel/delaunay.h"
#include "kernel/distinct_points.h"
#include "kernel/edge_order.h"
#include "kernel/egh.h"
#include "kernel/emst.h"
#include "kernel/gabriel.h"
#include "tests/support/graph_oracles.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

std::size_t missing(const std::vector<EdgeId>& edges, const Flags& flags) {
  return static_cast<std::size_t>(
      std::count_if(edges.begin(), edges.end(), [&](EdgeId e) { return !flags[+e]; }));
}

void check_chain(const std::vector<Point3>& input) {
  const DistinctPoints distinct = distinct_points(input);
  const TetComplex complex = delaunay(distinct);
  const Flags all(complex.edge_count(), 1);
  const auto by_length = edges_by_length(distinct.points, complex, all);
  const std::vector<EdgeId> tree = emst(complex, by_length);
  const std::vector<EdgeId> nearest = nearest_neighbor_graph(complex, by_length);
  const Flags gabriel = gabriel_edges(distinct.points, complex);
  const Egh egh = extended_gabriel_hypergraph(distinct.points, complex, gabriel);

  Flags in_tree(complex.edge_count(), 0);
  for (const EdgeId e : tree) in_tree[+e] = 1;
  CHECK(tree.size() + 1 == distinct.points.size());
  CHECK(2 * nearest.size() >= distinct.points.size());
  CHECK(missing(nearest, in_tree) == 0);
  CHECK(missing(tree, gabriel) == 0);

  std::size_t gabriel_not_egh = 0;
  for (std::size_t e = 0; e < gabriel.size(); ++e) gabriel_not_egh += gabriel[e] > egh.edges[e];
  CHECK(gabriel_not_egh == 0);

  std::size_t wrong_triangles = 0;
  for (std::uint32_t t = 0; t < complex.triangle_count(); ++t) {
    const auto [a, b, c] = complex.edges(TriangleId{t});
    wrong_triangles += egh.triangles[t] != (egh.edges[+a] & egh.edges[+b] & egh.edges[+c]);
  }
  CHECK(wrong_triangles == 0);
  CHECK(emst(complex, edges_by_length(distinct.points, complex, gabriel)) == tree);
}

TEST_CASE("small and middling solids") {
  for (const auto& sets : {oracle::small_solids(), oracle::middling_solids()}) {
    for (const auto& set : sets) {
      CAPTURE(set.name);
      check_chain(set.points);
    }
  }
}

TEST_CASE("20000 points on a bumpy sphere") { check_chain(point_sets::bumpy_sphere(20000, 1)); }

TEST_CASE("20000 points on a torus, far off") {
  check_chain(point_sets::translated(point_sets::random_torus(20000, 2), {5e5, 5.4e6, 100}));
}

TEST_CASE("10000 uniform points") { check_chain(point_sets::uniform_cube(10000, 3)); }

TEST_CASE("grids, exact and with rounded coordinates") {
  check_chain(point_sets::grid(16));
  check_chain(point_sets::grid(16, 0.1));
  check_chain(point_sets::scaled(point_sets::grid(12, 0.1), 0x1p490));
}

TEST_CASE("a large lattice sphere") { check_chain(point_sets::lattice_sphere(5001)); }

}  // namespace
}  // namespace tetsculpt
