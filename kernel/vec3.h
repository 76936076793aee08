#pragma once

#include <cmath>

/// Vector algebra over any number type: the predicates evaluate the same formula in doubles, on
/// absolute values (for error bounds) and in expansions.
namespace tetsculpt {

template <class T>
struct Vec3 {
  T x;
  T y;
  T z;
};

template <class T>
T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
Vec3<T> operator*(const Vec3<T>& a, const T& s) {
  return {a.x * s, a.y * s, a.z * s};
}

template <class T>
Vec3<T> operator+(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class T>
Vec3<T> operator-(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline Vec3<double> abs(const Vec3<double>& a) {
  return {std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)};
}

/// The cross product with all signs positive: the permanent that bounds its rounding error.
inline Vec3<double> cross_permanent(const Vec3<double>& a, const Vec3<double>& b) {
  return {a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x};
}

}  // namespace tetsculpt
