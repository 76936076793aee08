// edges_by_length sorts by exact length, then end points: every pair of edges against
// compare_lengths.
#include <doctest/doctest.h>

#include <algorithm>
#include <span>
#include <vector>

#include "kernel/delaunay.h"
#include "kernel/distinct_points.h"
#include "kernel/edge_order.h"
#include "kernel/predicates.h"
#include "tests/support/graph_oracles.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

/// Pairs of edges in the wrong order. All pairs, so that the order is seen to be transitive.
std::size_t inversions(std::span<const Point3> points, const TetComplex& complex,
                       const std::vector<EdgeId>& order) {
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      wrong += !oracle::shorter(points, complex.vertices(order[i]), complex.vertices(order[j]));
    }
  }
  return wrong;
}

void check_order(const std::vector<Point3>& input) {
  const DistinctPoints distinct = distinct_points(input);
  const TetComplex complex = delaunay(distinct);
  const Flags all(complex.edge_count(), 1);
  const auto order = edges_by_length(distinct.points, complex, all);
  CHECK(order.size() == complex.edge_count());
  CHECK(oracle::edges_of(complex, order) == oracle::flagged_edges(complex, all));
  CHECK(inversions(distinct.points, complex, order) == 0);
}

TEST_CASE("small solids") {
  for (const auto& set : oracle::small_solids()) {
    CAPTURE(set.name);
    check_order(set.points);
  }
}

TEST_CASE("large and small coordinates, with ties") {
  for (const double scale : {0x1p160, 1e40, 0.1, 1e-40, 0x1p-170}) {
    CAPTURE(scale);
    check_order(point_sets::scaled(point_sets::grid(4), scale));
    check_order(point_sets::translated(point_sets::scaled(point_sets::grid(4), scale),
                                       {scale / 3, 1e6 * scale, -7e9 * scale}));
  }
}

TEST_CASE("only the chosen edges, in the same order") {
  const DistinctPoints distinct = distinct_points(point_sets::random_lattice(100, 5, 1));
  const TetComplex complex = delaunay(distinct);
  Flags chosen(complex.edge_count(), 1);
  auto expected = edges_by_length(distinct.points, complex, chosen);
  for (std::size_t e = 0; e < chosen.size(); ++e) chosen[e] = e % 3 == 0;
  std::erase_if(expected, [](EdgeId e) { return +e % 3 != 0; });
  CHECK(edges_by_length(distinct.points, complex, chosen) == expected);
  CHECK(edges_by_length(distinct.points, complex, Flags(complex.edge_count(), 0)).empty());
}

TEST_CASE("no edges") { CHECK(edges_by_length({}, TetComplex(), {}).empty()); }

TEST_CASE("middling solids: each edge and the next") {
  for (const auto& set : oracle::middling_solids()) {
    CAPTURE(set.name);
    const DistinctPoints distinct = distinct_points(set.points);
    const TetComplex complex = delaunay(distinct);
    const auto order = edges_by_length(distinct.points, complex, Flags(complex.edge_count(), 1));
    std::size_t wrong = 0;
    for (std::size_t i = 1; i < order.size(); ++i) {
      wrong += !oracle::shorter(distinct.points, complex.vertices(order[i - 1]),
                                complex.vertices(order[i]));
    }
    CHECK(wrong == 0);
  }
}

}  // namespace
}  // namespace tetsculpt
