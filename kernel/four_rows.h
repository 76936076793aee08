#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "kernel/four_lanes.h"
#include "kernel/hull_facets.h"

/// Rows of four doubles, four rows at a time. Internal to kernel/lifted_hull.
namespace tetsculpt::hull {

using Two = double __attribute__((vector_size(16)));

/// Four rows of four doubles, a component in each vector.
struct FourRows {
  Four x, y, z, w;
};

/// Two doubles of an object, from the one at that place on.
template <std::size_t kPlace, class T>
TETSCULPT_FOUR_LANES inline Two two_of(const T& object) {
  static_assert(sizeof(T) >= (kPlace + 2) * sizeof(double));
  Two result;
  std::memcpy(&result, reinterpret_cast<const std::byte*>(&object) + kPlace * sizeof(double),
              sizeof result);
  return result;
}

/// No arrays of vectors, here and below: GCC would put them together in memory.
TETSCULPT_FOUR_LANES inline void transpose(Four& a, Four& b, Four& c, Four& d) {
  const Four ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Four ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Four cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Four cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

TETSCULPT_FOUR_LANES inline Four joined(const Two& low, const Two& high) {
#if defined(__x86_64__)
  return _mm256_insertf128_pd(_mm256_castpd128_pd256(low), high, 1);
#else
  return __builtin_shufflevector(low, high, 0, 1, 2, 3);
#endif
}

/// Two components of four objects.
template <std::size_t kPlace, class T>
TETSCULPT_FOUR_LANES inline void load_two(const T& a, const T& b, const T& c, const T& d,
                                          Four& first, Four& second) {
  const Four ac = joined(two_of<kPlace>(a), two_of<kPlace>(c));
  const Four bd = joined(two_of<kPlace>(b), two_of<kPlace>(d));
  first = __builtin_shufflevector(ac, bd, 0, 4, 2, 6);
  second = __builtin_shufflevector(ac, bd, 1, 5, 3, 7);
}

/// What four objects begin with.
template <class T>
TETSCULPT_FOUR_LANES inline FourRows rows(const T& a, const T& b, const T& c, const T& d) {
  FourRows result;
  load_two<0>(a, b, c, d, result.x, result.y);
  load_two<2>(a, b, c, d, result.z, result.w);
  return result;
}

/// The same number, or the same row, four times.
TETSCULPT_FOUR_LANES inline Four four_times(double number) { return number - Four{}; }
TETSCULPT_FOUR_LANES inline FourRows four_times(const LiftedDifference& q) {
  return {four_times(q.x), four_times(q.y), four_times(q.z), four_times(q.w)};
}

TETSCULPT_FOUR_LANES inline Four magnitude(const Four& a) {
  return reinterpret_cast<Four>(reinterpret_cast<FourLongs>(a) &
                                std::numeric_limits<std::int64_t>::max());
}

TETSCULPT_FOUR_LANES inline Four greater(const Four& a, const Four& b) { return a > b ? a : b; }

TETSCULPT_FOUR_LANES inline Four root(const Four& a) {
#if defined(__x86_64__)
  return _mm256_sqrt_pd(a);
#else
  return Four{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
}

/// a b + c, rounded once where the processor can.
TETSCULPT_FOUR_LANES inline Four fused(const Four& a, const Four& b, const Four& c) {
#if defined(__x86_64__)
  return _mm256_fmadd_pd(a, b, c);
#else
  return a * b + c;
#endif
}

/// a b - c d.
TETSCULPT_FOUR_LANES inline Four minor(const Four& a, const Four& b, const Four& c, const Four& d) {
#if defined(__x86_64__)
  return _mm256_fmsub_pd(a, b, c * d);
#else
  return a * b - c * d;
#endif
}

/// A bit per lane that holds: of a comparison.
template <class Comparison>
TETSCULPT_FOUR_LANES inline unsigned pattern(const Comparison& lanes) {
  return first_bits(reinterpret_cast<Four>(lanes));
}

/// Facets::height, of four facets, of which w is the offset. What is found with it waits for it,
/// step by step: added up in as few cycles as can be.
TETSCULPT_FOUR_LANES inline void four_heights(const FourRows& n, const FourRows& q, Four& value,
                                              Four& error) {
  value = fused(n.x, q.x, n.w) + fused(n.y, q.y, -q.w) + n.z * q.z;
  error = reinterpret_cast<Four>(reinterpret_cast<FourBits>(n.w) << 52);
}

}  // namespace tetsculpt::hull
