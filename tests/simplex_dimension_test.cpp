// first_simplex finds affinely independent points, as many as the set has.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/first_simplex.h"
#include "kernel/predicates.h"
#include "tests/support/graph_oracles.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

bool independent(const std::vector<Point3>& points, const FirstSimplex& simplex) {
  const auto p = [&](std::size_t i) -> const Point3& { return points[simplex.corners[i]]; };
  switch (simplex.size) {
    case 0:
    case 1:
      return true;
    case 2:
      return !(p(0) == p(1));
    case 3:
      return !collinear(p(0), p(1), p(2));
    default:
      return orient3d(p(0), p(1), p(2), p(3)) == Sign::kPositive;
  }
}

int dimension(const std::vector<Point3>& points) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    CAPTURE(seed);
    const std::vector<Point3> shuffled = point_sets::shuffled(points, seed);
    const FirstSimplex simplex = first_simplex(shuffled);
    CHECK(independent(shuffled, simplex));
    CHECK(simplex.size == first_simplex(points).size);
  }
  return first_simplex(points).size;
}

std::vector<Point3> integer_plane(const Point3& normal) {
  std::vector<Point3> points;
  for (const Point3& p : point_sets::grid(7)) {
    if (p.x * normal.x + p.y * normal.y + p.z * normal.z == 0) points.push_back(p);
  }
  return points;
}

TEST_CASE("nothing, a point, a line, a plane") {
  CHECK(dimension({}) == 0);
  CHECK(dimension({{1, 2, 3}}) == 1);
  CHECK(dimension({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}) == 1);
  CHECK(dimension({{0.0, 0, 0}, {-0.0, 0, 0}}) == 1);
  CHECK(dimension({{1, 2, 3}, {1, 2, 3}, {1, 2, 4}}) == 2);
  CHECK(dimension({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {-3, -6, -9}}) == 2);
  CHECK(dimension({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {1, 0, 0}}) == 3);
  CHECK(dimension(integer_plane({0, 0, 1})) == 3);
  CHECK(dimension(integer_plane({1, -2, 1})) == 3);
  CHECK(dimension(integer_plane({2, -1, -1})) == 3);
}

TEST_CASE("a solid") {
  CHECK(dimension({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) == 4);
  CHECK(dimension(point_sets::plane_and_apex(100, 1)) == 4);
  CHECK(dimension(point_sets::skew_lines(20)) == 4);
  CHECK(dimension(point_sets::uniform_cube(50, 2)) == 4);
}

TEST_CASE("one ulp makes the difference") {
  const double up = std::nextafter(1.0, 2.0);
  CHECK(dimension({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}) == 2);
  CHECK(dimension({{0, 0, 0}, {1, 1, up}, {2, 2, 2}}) == 3);
  CHECK(dimension({{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {2, 2, 1}}) == 3);
  CHECK(dimension({{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {2, 2, up}}) == 4);
}

int distinct_dimension(const std::vector<Point3>& points) {
  const DistinctPoints distinct = distinct_points(points);
  return dimension({distinct.points.begin(), distinct.points.end()});
}

TEST_CASE("the catalogue") {
  for (const auto& set : oracle::flat_sets()) {
    CAPTURE(set.name);
    CHECK(distinct_dimension(set.points) < 4);
  }
  for (const auto& set : oracle::small_solids()) {
    CAPTURE(set.name);
    CHECK(distinct_dimension(set.points) == 4);
  }
}

}  // namespace
}  // namespace tetsculpt
