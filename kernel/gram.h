#pragma once

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "kernel/ids.h"
#include "kernel/point.h"
#include "kernel/vec3.h"

/// Rounded scalar products of a tetrahedron's edges, from which several filters are made.
namespace tetsculpt {

/// With e_i the rounded differences of corners 1, 2, 3 from corner 0: e_i.e_j.
///
/// Per product, two differences, the product and two sums are rounded, so by Cauchy-Schwarz an
/// entry is off by at most 5 u M and terms of second order; u = 2^-53, M the largest diagonal
/// entry.
struct Gram {
  double g11, g22, g33, g12, g13, g23;

  double largest() const { return std::max(g11, std::max(g22, g33)); }
};

inline Gram gram(std::span<const Point3> points, const std::array<VertexId, 4>& corners) {
  const Point3& o = points[+corners[0]];
  const auto from_first = [&](std::size_t i) {
    const Point3& p = points[+corners[i]];
    return Vec3<double>{p.x - o.x, p.y - o.y, p.z - o.z};
  };
  const Vec3<double> e1 = from_first(1);
  const Vec3<double> e2 = from_first(2);
  const Vec3<double> e3 = from_first(3);
  return {dot(e1, e1), dot(e2, e2), dot(e3, e3), dot(e1, e2), dot(e1, e3), dot(e2, e3)};
}

/// Which of some values are surely negative, and which may have either sign: one bit each.
struct SignBits {
  std::uint32_t negative = 0;
  std::uint32_t doubtful = 0;
};

/// The sign bits of values[i] + shift, as bit i. With SSE2, which every x86-64 has, two at a time:
/// a fourth less instructions in all of the Gabriel test.
template <std::size_t N>
std::uint32_t shifted_sign_bits(const std::array<double, N>& values, double shift) {
  static_assert(N % 2 == 0 && N <= 32);
  std::uint32_t bits = 0;
#if defined(__SSE2__)
  const __m128d shifts = _mm_set1_pd(shift);
  for (std::size_t i = 0; i < N; i += 2) {
    const __m128d sums = _mm_add_pd(_mm_loadu_pd(&values[i]), shifts);
    bits |= static_cast<std::uint32_t>(_mm_movemask_pd(sums)) << i;
  }
#else
  for (std::size_t i = 0; i < N; ++i) {
    bits |= static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(values[i] + shift) >> 63) << i;
  }
#endif
  return bits;
}

/// Signs of values that are off by less than `error`; all are doubtful where products may have
/// overflowed, or underflowed by more than the error. Without branches: signs come without order.
template <std::size_t N>
SignBits sign_bits(const std::array<double, N>& values, double error) {
  constexpr std::uint32_t kAll = (1u << N) - 1;
  if (!(error > 0x1p-960 && error < 0x1p960)) return {0, kAll};
  // A rounded sum has the sign of the true one; sums that cancel are +0.
  const std::uint32_t negative = shifted_sign_bits(values, error);
  return {negative, shifted_sign_bits(values, -error) & ~negative};
}

}  // namespace tetsculpt
