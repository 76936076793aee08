// Points along a Hilbert curve: short steps, and an order that depends on the set alone.
#include "kernel/hilbert_order.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

std::vector<Point3> in_order(const std::vector<Point3>& points) {
  std::vector<Point3> sorted;
  for (const std::uint32_t i : hilbert_order(points)) sorted.push_back(points[i]);
  return sorted;
}

double distance(const Point3& a, const Point3& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

TEST_CASE("on a lattice of 4^3 the curve steps from neighbour to neighbour") {
  const std::vector<Point3> points = in_order(point_sets::grid(4));
  REQUIRE(points.size() == 64);
  int wrong = 0;
  for (std::size_t i = 1; i < points.size(); ++i) wrong += distance(points[i - 1], points[i]) != 1;
  CHECK(wrong == 0);
}

TEST_CASE("steps are short") {
  const std::vector<Point3> points = in_order(point_sets::uniform_cube(50000, 3));
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += distance(points[i - 1], points[i]);
  // A random order would have steps of 0.66 on average.
  CHECK(sum / static_cast<double>(points.size()) < 0.05);
}

TEST_CASE("steps are short among points that agree in the high bits of their places") {
  // The box is up to 2^14 times as large as the points' own.
  for (const std::size_t n : {200u, 5000u}) {
    std::vector<Point3> points = point_sets::uniform_cube(n, 5);
    points.push_back({0x1p14, 0x1p14, 0x1p14});
    const std::vector<Point3> sorted = in_order(points);
    REQUIRE(sorted.back() == points.back());
    double sum = 0;
    for (std::size_t i = 1; i < n; ++i) sum += distance(sorted[i - 1], sorted[i]);
    CHECK(sum / static_cast<double>(n) < 1.6 / std::cbrt(n));
  }
}

TEST_CASE("the same for every order of the input and every scale") {
  for (const std::vector<Point3>& points :
       {point_sets::uniform_cube(3000, 4), point_sets::random_lattice(500, 5, 3)}) {
    const std::vector<Point3> expected = in_order(points);
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      CAPTURE(seed);
      CHECK(in_order(point_sets::shuffled(points, seed)) == expected);
    }
    CHECK(in_order(point_sets::scaled(points, 0x1p100)) == point_sets::scaled(expected, 0x1p100));
  }
}

TEST_CASE("the same on any number of threads, points that agree in the high bits or not") {
  std::vector<Point3> points = point_sets::uniform_cube(20000, 6);
  for (const double far : {0.5, 0x1p14, 0x1p30}) {
    points.push_back({far, far, far});
    const auto expected = hilbert_order(points);
    for (const int threads : {2, 3, 4}) CHECK(hilbert_order(points, threads) == expected);
  }
}

TEST_CASE("in one cell: lexicographic, equal points by index") {
  // The far point makes one cell of all others.
  const std::vector<Point3> points{{1, 2, 3}, {1, 2, 2}, {1e9, 0, 0}, {0, 5, 0}, {1, 2, 3}};
  std::vector<std::uint32_t> indices;
  for (const std::uint32_t i : hilbert_order(points)) indices.push_back(i);
  CHECK(indices == std::vector<std::uint32_t>{3, 1, 0, 4, 2});
}

TEST_CASE("no point, one point, all equal") {
  CHECK(hilbert_order({}).empty());
  const std::vector<Point3> equal(1000, {0.1, -7, 1e20});
  const auto order = hilbert_order(equal);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < order.size(); ++i) wrong += order[i] != i;
  CHECK(wrong == 0);
}

}  // namespace
}  // namespace tetsculpt
