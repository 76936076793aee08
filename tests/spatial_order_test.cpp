// The order of insertion is a permutation in growing rounds, each along a Hilbert curve.
#include "kernel/spatial_order.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/distinct_points.h"
#include "tests/support/graph_oracles.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

bool permutation(const SpatialOrder& order, std::size_t n) {
  std::vector<VertexId> vertices = order.vertices;
  std::sort(vertices.begin(), vertices.end());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (+vertices[i] != i) return false;
  }
  return vertices.size() == n;
}

double distance(const Point3& a, const Point3& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

TEST_CASE("a permutation, cut into rounds") {
  auto sets = oracle::small_solids();
  for (const auto& more : {oracle::flat_sets(), oracle::middling_solids()}) {
    sets.insert(sets.end(), more.begin(), more.end());
  }
  sets.push_back({"20000 uniform", point_sets::uniform_cube(20000, 1)});
  for (const auto& set : sets) {
    CAPTURE(set.name);
    const std::vector<Point3> points = distinct_points(set.points).points;
    const SpatialOrder order = spatial_order(points);
    CHECK(permutation(order, points.size()));
    if (points.empty()) continue;
    REQUIRE(order.round_begin.size() >= 2);
    CHECK(order.round_begin.front() == 0);
    CHECK(order.round_begin.back() == points.size());
    CHECK(std::is_sorted(order.round_begin.begin(), order.round_begin.end()));
  }
}

TEST_CASE("a round is about as large as all before it") {
  const auto points = distinct_points(point_sets::uniform_cube(100000, 2)).points;
  const SpatialOrder order = spatial_order(points);
  CHECK(order.round_begin.size() > 8);
  for (std::size_t r = 2; r + 1 < order.round_begin.size(); ++r) {
    CAPTURE(r);
    const auto before = static_cast<double>(order.round_begin[r]);
    const double size = static_cast<double>(order.round_begin[r + 1]) - before;
    CHECK(size > 0.5 * before);
  }
}

TEST_CASE("on a lattice of 4^3 the curve steps from neighbour to neighbour") {
  const std::vector<Point3> points = point_sets::grid(4);
  const SpatialOrder order = spatial_order(points);
  REQUIRE(order.round_begin.size() == 2);
  int wrong = 0;
  for (std::size_t i = 1; i < order.vertices.size(); ++i) {
    wrong += distance(points[+order.vertices[i - 1]], points[+order.vertices[i]]) != 1;
  }
  CHECK(wrong == 0);
}

TEST_CASE("steps within a large round are short") {
  const auto points = distinct_points(point_sets::uniform_cube(50000, 3)).points;
  const SpatialOrder order = spatial_order(points);
  const std::size_t begin = order.round_begin[order.round_begin.size() - 2];
  double sum = 0;
  for (std::size_t i = begin + 1; i < order.vertices.size(); ++i) {
    sum += distance(points[+order.vertices[i - 1]], points[+order.vertices[i]]);
  }
  // A random order would have steps of 0.66 on average.
  CHECK(sum / static_cast<double>(order.vertices.size() - begin) < 0.06);
}

TEST_CASE("the same twice, and for the same points at another scale") {
  const auto points = point_sets::uniform_cube(3000, 4);
  const SpatialOrder order = spatial_order(points);
  CHECK(spatial_order(points).vertices == order.vertices);
  CHECK(spatial_order(point_sets::scaled(points, 0x1p100)).vertices == order.vertices);
}

}  // namespace
}  // namespace tetsculpt
