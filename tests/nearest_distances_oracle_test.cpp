// nearest_distances() against all pairs.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "kernel/nearest_distances.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

void check(const std::vector<Point3>& points) {
  const std::vector<double> distances = nearest_distances(points);
  REQUIRE(distances.size() == points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (i == j) continue;
      const double x = points[i].x - points[j].x;
      const double y = points[i].y - points[j].y;
      const double z = points[i].z - points[j].z;
      least = std::min(least, x * x + y * y + z * z);
    }
    CHECK(distances[i] == std::sqrt(least));
  }
}

TEST_CASE("in space") {
  check(point_sets::uniform_cube(700, 5));
  check(point_sets::torus(0.2, 3));
  check(point_sets::grid(7));
}

TEST_CASE("few points, on a line, in a plane, repeated") {
  check({});
  check({{1, 2, 3}});
  check({{1, 2, 3}, {1, 2, 4}});
  std::vector<Point3> line;
  std::vector<Point3> plane;
  for (int i = 0; i < 200; ++i) {
    line.push_back({double(i * i % 211), 0, 0});
    plane.push_back({1, double(i % 20), double(i * i % 37)});
  }
  check(line);
  check(plane);
  check(point_sets::joined(plane, plane));
}

}  // namespace
}  // namespace tetsculpt
