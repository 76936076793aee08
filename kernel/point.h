#pragma once

#include <cmath>

/// Points, and the one order in which everything that needs an order takes them.
namespace tetsculpt {

/// A point in space; the unit is the user's.
struct Point3 {
  double x = 0;
  double y = 0;
  double z = 0;

  /// Equality of values: -0.0 equals 0.0.
  friend bool operator==(const Point3&, const Point3&) = default;
};

/// No coordinate is NaN or infinite.
inline bool finite(const Point3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// Lexicographic order by x, then y, then z. Strict and total on finite points.
inline bool lexicographically_less(const Point3& a, const Point3& b) {
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  return a.z < b.z;
}

}  // namespace tetsculpt
