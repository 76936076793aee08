#include "io/unit_vectors.h"

#include <algorithm>
#include <cmath>

namespace tetsculpt {
namespace {

// Of a size at which squares, and those of products of two, neither overflow nor all underflow:
// where it has another, divided by its largest component. Zero stays zero.
Vec3<double> scaled(const Vec3<double>& v) {
  constexpr double kLargest = 1e70;
  const double scale = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (scale == 0 || (scale > 1 / kLargest && scale < kLargest)) return v;
  return {v.x / scale, v.y / scale, v.z / scale};
}

// Half of b - a if the whole overflows.
Vec3<double> finite_difference(const Point3& a, const Point3& b) {
  const Vec3<double> whole = {b.x - a.x, b.y - a.y, b.z - a.z};
  if (std::isfinite(whole.x) && std::isfinite(whole.y) && std::isfinite(whole.z)) return whole;
  return {b.x / 2 - a.x / 2, b.y / 2 - a.y / 2, b.z / 2 - a.z / 2};
}

}  // namespace

Vec3<double> unit(const Vec3<double>& v) {
  const Vec3<double> n = scaled(v);
  const double length = std::sqrt(dot(n, n));
  return length == 0 ? n : Vec3<double>{n.x / length, n.y / length, n.z / length};
}

Vec3<double> direction(const Point3& a, const Point3& b) { return unit(finite_difference(a, b)); }

Vec3<double> unit_normal(const Point3& a, const Point3& b, const Point3& c) {
  return unit(cross(scaled(finite_difference(a, b)), scaled(finite_difference(a, c))));
}

}  // namespace tetsculpt
