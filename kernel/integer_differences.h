#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "kernel/point.h"
#include "kernel/vec3.h"

/// Differences of coordinates as integers: on lattices and files of few digits, a polynomial over
/// them is exact in 128 bits at a tenth of the cost of expansions. Internal to kernel/predicates.
namespace tetsculpt {

#ifdef __SIZEOF_INT128__
__extension__ using Int128 = __int128;
#else
using Int128 = std::int64_t;
#endif

/// Integers of so many bits, in a polynomial of this degree with at most 256 monomials, keep all
/// intermediate results in an Int128.
constexpr int most_bits(int degree) {
  return (8 * static_cast<int>(sizeof(Int128)) - 1 - 8) / degree;
}

/// points - origin in units of their lowest set bit, if no difference is rounded and all are below
/// 2^bits then.
template <std::size_t N>
std::optional<std::array<Vec3<Int128>, N>> integer_differences(
    const std::array<const Point3*, N>& points, const Point3& origin, int bits) {
  std::array<double, 3 * N> d;
  bool rounded = false;
  const auto subtract = [&](double a, double b) {  // [Knuth 1969, two-sum]
    const double difference = a - b;
    const double b_part = a - difference;
    const double a_part = difference + b_part;
    rounded |= (b_part - b) + (a - a_part) != 0;
    return difference;
  };
  for (std::size_t i = 0; i < N; ++i) {
    d[3 * i] = subtract(points[i]->x, origin.x);
    d[3 * i + 1] = subtract(points[i]->y, origin.y);
    d[3 * i + 2] = subtract(points[i]->z, origin.z);
  }
  if (rounded) return std::nullopt;
  // Biased exponents of the lowest set bit of all and of the highest; no number is subnormal.
  constexpr int kMantissa = 52;
  int lowest = 4096;
  int highest = 0;
  for (const double x : d) {
    const auto pattern = std::bit_cast<std::uint64_t>(x);
    const int exponent = static_cast<int>(pattern >> kMantissa & 0x7ff);
    if (exponent == 0) continue;
    highest = std::max(highest, exponent);
    lowest =
        std::min(lowest, exponent - kMantissa + std::min(std::countr_zero(pattern), kMantissa));
  }
  if (highest - lowest >= bits) return std::nullopt;
  if (highest == 0) return std::array<Vec3<Int128>, N>{};
  const auto per_unit =
      std::bit_cast<double>(static_cast<std::uint64_t>(2046 - lowest) << kMantissa);
  std::array<Vec3<Int128>, N> result;
  const auto integer = [&](double x) { return Int128{static_cast<std::int64_t>(x * per_unit)}; };
  for (std::size_t i = 0; i < N; ++i) {
    result[i] = {integer(d[3 * i]), integer(d[3 * i + 1]), integer(d[3 * i + 2])};
  }
  return result;
}

}  // namespace tetsculpt
