#include "io/float_coordinates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace tetsculpt {
namespace {

using Axis = double Point3::*;

constexpr std::array<std::pair<Axis, const char*>, 3> kAxes = {
    {{&Point3::x, "x"}, {&Point3::y, "y"}, {&Point3::z, "z"}}};

bool fits(double offset) { return std::abs(offset) <= std::numeric_limits<float>::max(); }

bool survives(double coordinate, double origin) {
  const double offset = coordinate - origin;
  if (!fits(offset)) return false;
  const double rounded = static_cast<double>(static_cast<float>(offset));
  const double back = origin == 0 ? rounded : origin + rounded;  // 0 + -0.0 is 0
  return back == coordinate && std::signbit(back) == std::signbit(coordinate);
}

bool all_survive(std::span<const Point3> points, Axis axis, double origin) {
  return std::ranges::all_of(points, [&](const Point3& p) { return survives(p.*axis, origin); });
}

double origin_on(std::span<const Point3> points, Axis axis) {
  if (points.empty() || all_survive(points, axis, 0)) return 0;
  double low = points.front().*axis;
  double high = low;
  for (const Point3& p : points) {
    low = std::min(low, p.*axis);
    high = std::max(high, p.*axis);
  }
  const double half = high / 2 - low / 2;
  const double middle = low / 2 + high / 2;
  if (half == 0) return middle;
  const int exponent = std::ilogb(half);
  return std::scalbn(std::nearbyint(std::scalbn(middle, -exponent)), exponent);
}

}  // namespace

Point3 float_origin(std::span<const Point3> points) {
  return {origin_on(points, &Point3::x), origin_on(points, &Point3::y),
          origin_on(points, &Point3::z)};
}

std::optional<std::size_t> beyond_floats(std::span<const Point3> points, const Point3& origin) {
  const auto it = std::ranges::find_if(points, [&](const Point3& p) {
    return !fits(p.x - origin.x) || !fits(p.y - origin.y) || !fits(p.z - origin.z);
  });
  if (it == points.end()) return std::nullopt;
  return static_cast<std::size_t>(it - points.begin());
}

std::vector<std::string> rounded_axes(std::span<const Point3> points, const Point3& origin) {
  std::vector<std::string> names;
  for (const auto& [axis, name] : kAxes) {
    if (!all_survive(points, axis, origin.*axis)) names.emplace_back(name);
  }
  return names;
}

}  // namespace tetsculpt
