// Coordinates come into the range of exact arithmetic by a power of two and unchanged otherwise, or
// are refused with the index of the point to blame.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kernel/distinct_points.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

std::optional<std::size_t> refused(const std::vector<Point3>& points) {
  try {
    distinct_points(points);
  } catch (const InvalidPoint& error) {
    CHECK(std::string(error.what()).starts_with("point " + std::to_string(error.index()) + ": "));
    return error.index();
  }
  return std::nullopt;
}

bool in_range(std::span<const Point3> points) {
  for (const Point3& p : points) {
    for (const double x : {p.x, p.y, p.z}) {
      const double units = std::ldexp(x, -kMinExponent);
      if (std::fabs(x) >= std::ldexp(1, kMaxExponent) || std::trunc(units) != units) return false;
    }
  }
  return true;
}

/// Each input point times 2^scale_exponent, to the bit, is its vertex.
bool scaled_exactly(const DistinctPoints& distinct, const std::vector<Point3>& input) {
  const int back = -distinct.scale_exponent;
  for (std::size_t i = 0; i < input.size(); ++i) {
    const Point3& p = distinct.points[+distinct.vertex_of_input[i]];
    const Point3 q{std::ldexp(p.x, back), std::ldexp(p.y, back), std::ldexp(p.z, back)};
    if (!(q == input[i])) return false;
  }
  return true;
}

void check_scaled(const std::vector<Point3>& input, bool scale_expected) {
  const DistinctPoints distinct = distinct_points(input);
  CAPTURE(distinct.scale_exponent);
  CHECK((distinct.scale_exponent != 0) == scale_expected);
  CHECK(in_range(distinct.points));
  CHECK(scaled_exactly(distinct, input));
  CHECK_FALSE(broken_invariant(distinct, input));
}

TEST_CASE("NaN and infinity are refused with their index") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, -nan, infinity, -infinity}) {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<Point3> points(10, {1, 2, 3});
      Point3& p = points[7];
      (axis == 0 ? p.x : axis == 1 ? p.y : p.z) = bad;
      points[9] = {nan, nan, nan};
      CAPTURE(bad);
      CAPTURE(axis);
      CHECK(refused(points) == 7u);
    }
  }
}

TEST_CASE("huge and tiny sets are scaled, ordinary ones are not") {
  const auto unit = point_sets::uniform_cube(500, 1);
  check_scaled(unit, false);
  check_scaled(point_sets::scaled(unit, 1e30), false);
  check_scaled(point_sets::scaled(unit, 1e-30), false);
  check_scaled(point_sets::scaled(unit, 1e150), true);
  check_scaled(point_sets::scaled(unit, 1e-140), true);
  check_scaled(point_sets::scaled(unit, 1e308), true);
}

TEST_CASE("denormal coordinates are scaled exactly") {
  const double tiny = std::numeric_limits<double>::denorm_min();
  check_scaled({{tiny, 0, 0}, {0, 3 * tiny, 0}, {0, 0, -1000 * tiny}, {tiny, tiny, tiny}}, true);
  check_scaled(point_sets::scaled(point_sets::uniform_cube(100, 2), 1e-310), true);
}

TEST_CASE("the ends of the range") {
  const double top = std::ldexp(1, kMaxExponent);
  const double bottom = std::ldexp(1, kMinExponent);
  check_scaled({{std::nextafter(top, 0), 0, 0}, {bottom, 0, 0}}, false);
  check_scaled({{top, 0, 0}, {1, 0, 0}}, true);
  check_scaled({{0, -top, 0}, {2 * bottom, 0, 0}}, true);
  check_scaled({{bottom / 2, 0, 0}, {0, 0, top / 4}}, true);
  CHECK(refused({{0, 0, 0}, {top, 0, 0}, {1, 1, 1}, {1, -bottom, 0}}) == 3u);
  CHECK(refused({{0, top / 2, 0}, {0, 0, bottom / 2}, {1, 1, 1}}) == 1u);
}

TEST_CASE("too wide a spread is refused, naming the point with the smallest digit") {
  CHECK(refused({{1, 1, 1}, {1e300, 0, 0}, {1, 1e-5, 0}, {2, 2, 2}}) == 2u);
  CHECK(refused({{1, 1, 1}, {0, std::numeric_limits<double>::denorm_min(), 0}}) == 1u);
  const double max = std::numeric_limits<double>::max();
  CHECK(refused({{max, max, max}, {-max, 0, 0}, {0, 0, 1e-300}}) == 2u);
}

TEST_CASE("the scale does not change the order") {
  const auto unit = point_sets::random_lattice(200, 5, 3);
  const DistinctPoints small = distinct_points(unit);
  const DistinctPoints huge = distinct_points(point_sets::scaled(unit, 0x1p900));
  CHECK(huge.vertex_of_input == small.vertex_of_input);
  CHECK(huge.first_input == small.first_input);
}

TEST_CASE("unit_exponent is the lowest set bit of all coordinates") {
  const auto unit = [](const std::vector<Point3>& points) { return unit_exponent(points, 10'000); };
  CHECK(unit({}) == 0);
  CHECK(unit({{0, -0.0, 0}}) == 0);
  CHECK(unit({{1, 0, 0}}) == 0);
  CHECK(unit({{8, 0, -24}}) == 3);
  CHECK(unit({{8, 0, -24}, {0, 0.75, 0}}) == -2);
  CHECK(unit({{0x1p160, 0, 0}, {0, 0x3p161, 0}}) == 160);
  CHECK(unit({{1 + 0x1p-52, 0, 0}}) == -52);
  CHECK(unit({{0, 0, std::numeric_limits<double>::denorm_min()}}) == -1074);
  CHECK(unit({{0, 0, std::numeric_limits<double>::max()}}) == 971);
  const std::vector<Point3> ten_bits{{0, 1023, 0}, {2, 0, 1}};
  CHECK(unit_exponent(ten_bits, 10) == 0);
  CHECK(unit_exponent(ten_bits, 9) == std::nullopt);
  CHECK(unit_exponent({}, 0) == 0);
}

}  // namespace
}  // namespace tetsculpt
