#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>

#include "kernel/point.h"

/// Hard cases for predicates, made on purpose: exactly degenerate configurations built from
/// integers, moved by similarities that don't round, and then nudged by an ulp. Same seed, same
/// cases, on every platform: no distribution of the standard library is used.
namespace tetsculpt::near_degenerate {

using Rng = std::mt19937_64;
using Vector = std::array<std::int64_t, 3>;
template <std::size_t kCount>
using Vectors = std::array<Vector, kCount>;
template <std::size_t kCount>
using Points = std::array<Point3, kCount>;

inline std::int64_t random_in(Rng& rng, std::int64_t low, std::int64_t high) {
  return low + static_cast<std::int64_t>(rng() % static_cast<std::uint64_t>(high - low + 1));
}

/// A vector with coordinates in [-reach, reach].
inline Vector random_vector(Rng& rng, std::int64_t reach) {
  return {random_in(rng, -reach, reach), random_in(rng, -reach, reach),
          random_in(rng, -reach, reach)};
}

/// A random permutation with random signs: of a vector, it keeps the length.
template <class Number, std::size_t kSize>
std::array<Number, kSize> signed_permutation(Rng& rng, std::array<Number, kSize> v) {
  for (std::size_t i = 0; i < kSize; ++i) {
    std::swap(v[i], v[i + rng() % (kSize - i)]);
    if (rng() % 2 == 0) v[i] = -v[i];
  }
  return v;
}

/// Rotates by the quaternion q and scales by |q|^2: no division.
inline Vector rotated(const std::array<std::int64_t, 4>& q, const Vector& v) {
  const auto [w, x, y, z] = q;
  return {(w * w + x * x - y * y - z * z) * v[0] + 2 * (x * y - w * z) * v[1] +
              2 * (x * z + w * y) * v[2],
          2 * (x * y + w * z) * v[0] + (w * w - x * x + y * y - z * z) * v[1] +
              2 * (y * z - w * x) * v[2],
          2 * (x * z - w * y) * v[0] + 2 * (y * z + w * x) * v[1] +
              (w * w - x * x - y * y + z * z) * v[2]};
}

/// Integer vectors of one length, some of them in the plane z = 0; coordinates below 2^15.
class EqualVectors {
 public:
  explicit EqualVectors(Rng& rng) {
    const std::int64_t reach = std::int64_t{1} << random_in(rng, 0, 6);
    x_ = random_in(rng, 1, reach);
    y_ = random_in(rng, 0, reach);
    turn_ = rng() % 2 == 0 ? 0 : random_in(rng, 1, 8);
    if (turn_ > 0) keep_ = random_in(rng, 1, 8);
  }

  Vector on_sphere(Rng& rng) const {
    const auto quaternion = signed_permutation<std::int64_t, 4>(rng, {keep_, turn_, 0, 0});
    return rotated(quaternion, signed_permutation<std::int64_t, 3>(rng, {x_, y_, 0}));
  }

  Vector on_circle(Rng& rng) const {
    const auto [x, y] = signed_permutation<std::int64_t, 2>(rng, {x_, y_});
    const auto [keep, turn] = signed_permutation<std::int64_t, 2>(rng, {keep_, turn_});
    return rotated({keep, 0, 0, turn}, {x, y, 0});
  }

 private:
  std::int64_t x_ = 0, y_ = 0, keep_ = 1, turn_ = 0;
};

/// An exponent e such that a 52-bit integer times 2^e is in the domain; often at its ends.
inline int random_exponent(Rng& rng) {
  switch (rng() % 8) {
    case 0:
      return -179;
    case 1:
      return 115;
    case 2:
      return static_cast<int>(random_in(rng, -179, 115));
    default:
      return static_cast<int>(random_in(rng, -52, 0));
  }
}

/// An integer similarity, then a scaling by a power of two. Exact for coordinates up to 2^16.
class LatticeMap {
 public:
  explicit LatticeMap(Rng& rng) : exponent_(random_exponent(rng)) {
    const std::int64_t turn_reach = std::int64_t{1} << random_in(rng, 0, 12);
    for (std::int64_t& component : rotation_) component = random_in(rng, -turn_reach, turn_reach);
    if (rng() % 4 == 0 || rotation_ == std::array<std::int64_t, 4>{}) rotation_ = {1, 0, 0, 0};
    offset_ = random_vector(rng, std::int64_t{1} << random_in(rng, 0, 51));
    if (rng() % 4 == 0) offset_ = {};
  }

  Point3 operator()(const Vector& v) const {
    const Vector r = rotated(rotation_, v);
    const auto place = [this, &r](std::size_t i) {
      return std::ldexp(static_cast<double>(r[i] + offset_[i]), exponent_);
    };
    return {place(0), place(1), place(2)};
  }

 private:
  std::array<std::int64_t, 4> rotation_{};
  Vector offset_{};
  int exponent_ = 0;
};

/// The exact images of an integer configuration under one random map.
template <std::size_t kCount>
Points<kCount> mapped(Rng& rng, const Vectors<kCount>& vectors) {
  Points<kCount> points;
  std::transform(vectors.begin(), vectors.end(), points.begin(), LatticeMap(rng));
  return points;
}

/// The distance from |x| to the next double, but at least the domain's lowest bit.
inline double ulp(double x) {
  return std::max(std::nextafter(std::fabs(x), HUGE_VAL) - std::fabs(x), 0x1p-179);
}

/// Moves single coordinates by an ulp or a few, or all of them by up to many, so that the
/// polynomials' values spread over all magnitudes at which a filter may begin to decide.
template <std::size_t kCount>
void nudge(Rng& rng, Points<kCount>& points) {
  double largest = 0;
  for (const Point3& p : points) {
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  const bool all = rng() % 2 == 0;
  const std::int64_t reach = all ? std::int64_t{1} << random_in(rng, 0, 16) : 3;
  const std::uint64_t chosen = rng() % (3 * kCount);
  std::uint64_t index = 0;
  for (Point3& p : points) {
    for (double* x : {&p.x, &p.y, &p.z}) {
      if (!all && index++ != chosen) continue;
      const double step = *x == 0 && rng() % 16 != 0 ? ulp(largest) : ulp(*x);
      *x += step * static_cast<double>(random_in(rng, -reach, reach));
    }
  }
}

/// Coordinates of one kind, to be mixed by the caller.
inline double small_integer(Rng& rng) {
  const auto x = static_cast<double>(random_in(rng, -2, 2));
  return rng() % 2 == 0 ? x : -x;  // both zeros
}
inline double full_mantissa(Rng& rng) { return 1 + static_cast<double>(rng() >> 12) * 0x1p-52; }
inline double clustered(Rng& rng) {
  const double cluster = 1 + 1e-12 * static_cast<double>(rng() % 3);
  return cluster + 0x1p-52 * static_cast<double>(rng() % 4);
}
inline double far_off(Rng& rng) { return 1e7 + (full_mantissa(rng) - 1.5); }
/// A double of either sign with its leading bit at 2^lowest to 2^highest.
inline double of_magnitude(Rng& rng, int lowest, int highest) {
  const double mantissa = rng() % 2 == 0 ? full_mantissa(rng) : -full_mantissa(rng);
  return std::ldexp(mantissa, static_cast<int>(random_in(rng, lowest, highest)));
}
/// Any double of moderate size: the differences of two of them are rarely doubles.
inline double ragged(Rng& rng) { return of_magnitude(rng, -60, 60); }
inline double any_magnitude(Rng& rng) { return of_magnitude(rng, -127, 167); }
inline double end_of_domain(Rng& rng) {
  const double sign = rng() % 2 == 0 ? 1 : -1;
  switch (rng() % 6) {
    case 0:
      return 0;
    case 1:
      return sign * 0x1p-179;
    case 2:
      return sign * 0x1p-170;
    case 3:
      return sign * 0x1p160;
    default:
      return sign * 0x1.fffffffffffffp167;
  }
}

template <std::size_t kCount>
Points<kCount> random_points(Rng& rng, double (*coordinate)(Rng&), int exponent = 0) {
  Points<kCount> points;
  for (Point3& p : points) {
    for (double* x : {&p.x, &p.y, &p.z}) *x = std::ldexp(coordinate(rng), exponent);
  }
  return points;
}

/// Points of a sphere about zero, or, if `planar`, of a circle with z = 0: the signed permutations
/// of three or two numbers. Cospherical although the differences of coordinates are not exact in
/// doubles.
template <std::size_t kCount>
Points<kCount> ragged_sphere(Rng& rng, bool planar) {
  const std::array<double, 3> radii{ragged(rng), ragged(rng), planar ? 0 : ragged(rng)};
  Points<kCount> points;
  for (Point3& p : points) {
    if (planar) {
      const auto [x, y] = signed_permutation<double, 2>(rng, {radii[0], radii[1]});
      p = {x, y, 0};
    } else {
      const auto [x, y, z] = signed_permutation<double, 3>(rng, radii);
      p = {x, y, z};
    }
  }
  return points;
}

/// The mix that every predicate is tested with. Half of it comes from `make_degenerate`, which
/// returns an exactly degenerate configuration; half of that is nudged.
template <std::size_t kCount, class MakeDegenerate>
Points<kCount> hard_case(Rng& rng, const MakeDegenerate& make_degenerate) {
  switch (rng() % 32) {
    case 0:
      return random_points<kCount>(rng, any_magnitude);
    case 1:
      return random_points<kCount>(rng, end_of_domain);
    case 2:
    case 3:
    case 4:
      return random_points<kCount>(rng, clustered);
    case 5:
    case 6:
    case 7:
      return random_points<kCount>(rng, far_off);
    case 8:
    case 9:
    case 10:
    case 11:
      return random_points<kCount>(rng, full_mantissa);
    case 12:
      return random_points<kCount>(rng, small_integer, random_exponent(rng));
    case 13:
    case 14:
    case 15:
      return random_points<kCount>(rng, small_integer);
    default:
      break;
  }
  Points<kCount> points = make_degenerate(rng);
  if (rng() % 2 == 0) nudge(rng, points);
  return points;
}

}  // namespace tetsculpt::near_degenerate
