// Equal points become one vertex, and the maps say who is who.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/distinct_points.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

std::vector<std::size_t> vertices_of(const DistinctPoints& distinct) {
  std::vector<std::size_t> vertices;
  for (const VertexId v : distinct.vertex_of_input) vertices.push_back(+v);
  return vertices;
}

TEST_CASE("duplicates are merged, the first one is named") {
  const std::vector<Point3> input{{2, 0, 0}, {1, 5, 0}, {2, 0, 0}, {1, 4, 9}, {1, 5, 0}, {1, 5, 0}};
  const DistinctPoints distinct = distinct_points(input);
  REQUIRE(distinct.points.size() == 3);
  for (std::size_t i = 0; i < input.size(); ++i) {
    CHECK(distinct.points[+distinct.vertex_of_input[i]] == input[i]);
  }
  const std::size_t firsts[] = {0, 1, 0, 3, 1, 1};
  for (std::size_t i = 0; i < input.size(); ++i) {
    CHECK(distinct.first_input[+distinct.vertex_of_input[i]] == firsts[i]);
  }
  CHECK(distinct.scale_exponent == 0);
  CHECK_FALSE(broken_invariant(distinct, input));
}

TEST_CASE("-0.0 equals 0.0 in every coordinate") {
  const std::vector<Point3> input{{0.0, -0.0, 1}, {-0.0, 0.0, 1}, {-0.0, -0.0, 1}, {0, 0, -1}};
  const DistinctPoints distinct = distinct_points(input);
  CHECK(vertices_of(distinct) == std::vector<std::size_t>{1, 1, 1, 0});
  CHECK(distinct.first_input == LargeArray<std::uint32_t>{3, 0});
  CHECK_FALSE(broken_invariant(distinct, input));
}

TEST_CASE("no point, one point, all equal") {
  const DistinctPoints none = distinct_points({});
  CHECK(none.points.empty());
  CHECK(none.vertex_of_input.empty());
  CHECK_FALSE(broken_invariant(none, {}));
  const DistinctPoints one = distinct_points(std::vector<Point3>(1000, {0.1, -7, 1e20}));
  CHECK(one.points == LargeArray<Point3>{{0.1, -7, 1e20}});
  CHECK(one.first_input == LargeArray<std::uint32_t>{0});
  CHECK(vertices_of(one) == std::vector<std::size_t>(1000, 0));
}

TEST_CASE("a lattice with many duplicates") {
  constexpr std::uint64_t kSeed = 2;
  CAPTURE(kSeed);
  const std::vector<Point3> input = point_sets::random_lattice(5000, 9, kSeed);
  LargeArray<Point3> expected(input.begin(), input.end());
  std::sort(expected.begin(), expected.end(), lexicographically_less);
  expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
  const DistinctPoints distinct = distinct_points(input);
  LargeArray<Point3> sorted = distinct.points;
  std::sort(sorted.begin(), sorted.end(), lexicographically_less);
  CHECK(sorted == expected);
  CHECK_FALSE(broken_invariant(distinct, input));
  std::size_t wrong = 0;
  for (std::size_t v = 0; v < distinct.points.size(); ++v) {
    const auto first = std::find(input.begin(), input.end(), distinct.points[v]);
    wrong += distinct.first_input[v] != static_cast<std::size_t>(first - input.begin());
  }
  CHECK(wrong == 0);
}

TEST_CASE("the same on several threads") {
  // Many cells hold equal points, one nearly half of them, and threads' shares begin among those.
  std::vector<Point3> input = point_sets::random_lattice(30000, 20, 5);
  for (std::size_t i = 0; i < input.size(); i += 2) input[i] = {7, 7, 7};
  const DistinctPoints one = distinct_points(input);
  CHECK_FALSE(broken_invariant(one, input));
  for (const int threads : {2, 3, 7}) {
    CAPTURE(threads);
    const DistinctPoints several = distinct_points(input, threads);
    CHECK(several.points == one.points);
    CHECK(several.first_input == one.first_input);
    CHECK(vertices_of(several) == vertices_of(one));
  }
}

TEST_CASE("the first faulty point on several threads") {
  std::vector<Point3> input = point_sets::uniform_cube(30000, 6);
  const auto faulty = [&](std::size_t at) {
    try {
      distinct_points(input, 3);
    } catch (const InvalidPoint& error) {
      return error.index() == at;
    }
    return false;
  };
  input[29000].x = 0x1p-1070;
  input[15000].x = 0x1p-1070;
  CHECK(faulty(15000));
  input[28000].z = NAN;
  input[12000].y = HUGE_VAL;
  CHECK(faulty(12000));
}

TEST_CASE("the points do not depend on the order of the input") {
  const std::vector<Point3> input = point_sets::random_lattice(500, 5, 3);
  const LargeArray<Point3> expected = distinct_points(input).points;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    CAPTURE(seed);
    CHECK(distinct_points(point_sets::shuffled(input, seed)).points == expected);
  }
}

}  // namespace
}  // namespace tetsculpt
