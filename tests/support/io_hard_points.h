#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <vector>

#include "kernel/point.h"

/// Numbers that text and byte order are likely to break.
namespace tetsculpt::testing {

/// Finite values of every kind, with both neighbours of each.
template <typename Float>
std::vector<Float> hard_numbers() {
  using Limits = std::numeric_limits<Float>;
  std::vector<Float> numbers;
  for (const Float value : {Float(0), Float(0.1), Float(1), Float(1.0 / 3), Float(123456.789),
                            Float(1e16), Float(1e-30), Float(1e30), Limits::min(),
                            Limits::denorm_min(), Limits::max() / 2, Limits::max()}) {
    for (const Float near :
         {value, std::nextafter(value, Float(0)), std::nextafter(value, Limits::infinity())}) {
      if (!std::isfinite(near)) continue;
      numbers.push_back(near);
      numbers.push_back(-near);
    }
  }
  return numbers;
}

/// `count` finite values with random bits.
template <typename Float, typename Bits>
std::vector<Float> random_bit_patterns(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Float> numbers;
  while (numbers.size() < count) {
    const auto value = std::bit_cast<Float>(static_cast<Bits>(random()));
    if (std::isfinite(value)) numbers.push_back(value);
  }
  return numbers;
}

/// Points whose coordinates run through `numbers`, each number in each place.
template <typename Float>
std::vector<Point3> points_of(const std::vector<Float>& numbers) {
  std::vector<Point3> points;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto at = [&](std::size_t k) {
      return static_cast<double>(numbers[(i + k) % numbers.size()]);
    };
    points.push_back({at(0), at(1), at(2)});
  }
  return points;
}

/// Equality of bits: -0.0 differs from 0.0.
inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

inline bool same_bits(std::span<const Point3> a, std::span<const Point3> b) {
  return std::ranges::equal(a, b, [](const Point3& p, const Point3& q) {
    return same_bits(p.x, q.x) && same_bits(p.y, q.y) && same_bits(p.z, q.z);
  });
}

}  // namespace tetsculpt::testing
