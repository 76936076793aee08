// The origin from which coordinates are written as floats, and what it says of the loss.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "io/float_coordinates.h"
#include "tests/support/io_hard_points.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

using Names = std::vector<std::string>;

TEST_CASE("floats need no origin") {
  CHECK(float_origin({}) == Point3{});
  const auto points = testing::points_of(testing::hard_numbers<float>());
  CHECK(float_origin(points) == Point3{});
  CHECK(rounded_axes(points) == Names{});
  CHECK_FALSE(beyond_floats(points));
}

TEST_CASE("each axis on its own") {
  const std::vector<Point3> points = {{0.1, 1, 1}, {0.3, 2, 1e10 + 1}};
  const Point3 origin = float_origin(points);
  CHECK(origin.x != 0);
  CHECK(origin.y == 0);
  CHECK(origin.z != 0);
  CHECK(rounded_axes(points) == Names{"x", "z"});
}

TEST_CASE("millimetres far away: the difference to the truth is that of floats near zero") {
  auto points = point_sets::scaled(point_sets::uniform_cube(1000, 3), 100);
  points = point_sets::translated(points, {3'512'345.678, -5'412'345.678, 0});
  const Point3 origin = float_origin(points);
  CHECK(static_cast<double>(static_cast<float>(origin.x)) == origin.x);
  CHECK(static_cast<double>(static_cast<float>(origin.y)) == origin.y);
  for (const Point3& p : points) {
    const double back = origin.x + static_cast<double>(static_cast<float>(p.x - origin.x));
    CHECK(std::abs(back - p.x) <= 64 * 0x1p-24);
  }
}

TEST_CASE("one value on an axis, and grids far away, are exact") {
  const std::vector<Point3> flat = {{0.1, 1e8 + 0.25, 0}, {0.1, 1e8 + 0.5, 0}, {0.1, 1e8 + 8, 0}};
  CHECK(rounded_axes(flat) == Names{"x", "y"});
  CHECK(rounded_axes(flat, float_origin(flat)) == Names{});
}

TEST_CASE("a sign of zero counts") {
  const std::vector<Point3> points = {{-0.0, 0, 0}, {1, 0, 0}};
  CHECK(rounded_axes(points) == Names{});
  CHECK(rounded_axes(points, {1, 0, 0}) == Names{"x"});
}

TEST_CASE("beyond floats") {
  constexpr double kLargest = std::numeric_limits<float>::max();
  constexpr double kAbove = 1e39;
  CHECK(beyond_floats(std::vector<Point3>{{0, 0, 0}, {0, -kLargest, 0}, {0, 0, kAbove}}) == 2);
  CHECK_FALSE(beyond_floats(std::vector<Point3>{{0, kAbove, 0}}, {0, kAbove, 0}));
  constexpr double kHuge = std::numeric_limits<double>::max();
  const std::vector<Point3> widest = {{-kHuge, 0, 0}, {kHuge, 0, 0}};
  CHECK(std::isfinite(float_origin(widest).x));
  CHECK(beyond_floats(widest, float_origin(widest)) == 0);
  CHECK(rounded_axes(widest, float_origin(widest)) == Names{"x"});
}

}  // namespace
}  // namespace tetsculpt
