// Lengths that doubles cannot tell apart, or tell apart wrongly, are ordered exactly.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "kernel/delaunay.h"
#include "kernel/distinct_points.h"
#include "kernel/edge_order.h"
#include "tests/support/graph_oracles.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

/// Edges given by their vectors: number k runs from (16 k, 0, 0), far from all others, so that it
/// is an edge of the complex. Two more points make a solid.
std::vector<Point3> far_apart(const std::vector<Point3>& vectors) {
  std::vector<Point3> points;
  for (const Point3& v : vectors) {
    const auto x = static_cast<double>(8 * points.size());
    points.push_back({x, 0, 0});
    points.push_back({x + v.x, v.y, v.z});
  }
  points.push_back({1, 900, 2});
  points.push_back({2, 1, 900});
  return points;
}

/// The numbers of the vectors, shortest first.
std::vector<std::size_t> ranking(const std::vector<Point3>& vectors) {
  const auto input = far_apart(vectors);
  const DistinctPoints distinct = distinct_points(input);
  const TetComplex complex = delaunay(distinct);
  std::vector<std::size_t> numbers;
  for (const EdgeId e : edges_by_length(distinct.points, complex, Flags(complex.edge_count(), 1))) {
    const auto [a, b] = complex.vertices(e);
    const std::size_t i = std::min(distinct.first_input[+a], distinct.first_input[+b]);
    const std::size_t j = std::max(distinct.first_input[+a], distinct.first_input[+b]);
    if (i % 2 == 0 && j == i + 1 && j < 2 * vectors.size()) numbers.push_back(i / 2);
  }
  return numbers;
}

/// The numbers of the vectors by the ids of their end points.
std::vector<std::size_t> by_ids(const std::vector<Point3>& vectors) {
  const DistinctPoints distinct = distinct_points(far_apart(vectors));
  std::vector<std::size_t> numbers(vectors.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  std::ranges::sort(numbers, {}, [&](std::size_t k) {
    const auto& vertex = distinct.vertex_of_input;
    return std::min(+vertex[2 * k], +vertex[2 * k + 1]);
  });
  return numbers;
}

double squared_length_in_doubles(const Point3& v) { return v.x * v.x + v.y * v.y + v.z * v.z; }

TEST_CASE("the same rounded length, different exact lengths") {
  const std::vector<Point3> vectors{
      {1, 0x1p-30, 0}, {1, 0, 0}, {1, 0, 0x1p-31}, {1, 0x1p-30, 0x1p-40}, {1, 0x1p-40, 0}};
  for (const Point3& v : vectors) REQUIRE(squared_length_in_doubles(v) == 1);
  CHECK(ranking(vectors) == std::vector<std::size_t>{1, 4, 2, 0, 3});
}

TEST_CASE("the same exact length, different rounded lengths: by end points") {
  int seen = 0;
  point_sets::Random random(1);
  for (int round = 0; round < 20; ++round) {
    CAPTURE(round);
    std::array<double, 3> c;
    // With 28 bits a squared length has 57 to 61, a little more than a double.
    const int bits = round % 2 == 0 ? 28 : 40;
    for (double& x : c) x = 1 + std::ldexp(static_cast<double>(random.below(1ull << bits)), -bits);
    std::sort(c.begin(), c.end());
    std::vector<Point3> vectors;
    do {
      vectors.push_back({c[0], c[1], c[2]});
    } while (std::next_permutation(c.begin(), c.end()));
    for (const Point3& v : vectors) {
      seen += squared_length_in_doubles(v) != squared_length_in_doubles(vectors[0]);
    }
    CHECK(ranking(vectors) == by_ids(vectors));
  }
  CHECK(seen > 10);
}

TEST_CASE("rounded lengths in the wrong order") {
  // A vector against a turned copy of it whose smallest coordinate is a little shorter.
  int misleading = 0;
  point_sets::Random random(2);
  for (int round = 0; round < 200; ++round) {
    CAPTURE(round);
    std::array<double, 3> c;
    for (double& x : c) x = 1 + static_cast<double>(random.below(1ull << 40)) * 0x1p-40;
    c[2] = random.uniform() < 0.5 ? 0x1p-20 : 0x1p-18;
    const std::vector<Point3> vectors{{c[0], c[1], c[2] + 0x1p-38}, {c[1], c[2], c[0]}};
    misleading += squared_length_in_doubles(vectors[0]) <= squared_length_in_doubles(vectors[1]);
    CHECK(ranking(vectors) == std::vector<std::size_t>{1, 0});
  }
  CHECK(misleading > 10);
}

TEST_CASE("all lengths of a lattice, rounded coordinates") {
  // 0.1 i is not equally spaced in doubles: nearly all ties are broken by the last bits.
  const auto points = distinct_points(point_sets::grid(4, 0.1));
  const TetComplex complex = delaunay(points);
  const auto order = edges_by_length(points.points, complex, Flags(complex.edge_count(), 1));
  const auto end = [&](std::size_t i) { return complex.vertices(order[i]); };
  std::size_t wrong = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    wrong += !oracle::shorter(points.points, end(i - 1), end(i));
  }
  CHECK(wrong == 0);
}

}  // namespace
}  // namespace tetsculpt
