#pragma once

#include <algorithm>
#include <array>
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

/// Signs of values that are off by less than `error`; all are doubtful where products may have
/// overflowed, or underflowed by more than the error. Without branches: signs come without order.
template <std::size_t N>
SignBits sign_bits(const std::array<double, N>& values, double error) {
  constexpr std::uint32_t kAll = (1u << N) - 1;
  if (!(error > 0x1p-960 && error < 0x1p960)) return {0, kAll};
  SignBits bits;
  for (std::size_t i = 0; i < N; ++i) {
    // A rounded sum has the sign of the true one.
    bits.negative |= std::uint32_t{values[i] + error < 0} << i;
    bits.doubtful |= std::uint32_t{values[i] - error < 0} << i;
  }
  bits.doubtful &= ~bits.negative;
  return bits;
}

}  // namespace tetsculpt
