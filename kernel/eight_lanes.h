#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "kernel/four_lanes.h"

/// Eight indices at a time, see kernel/four_lanes.h. Internal to kernel/simplices.
namespace tetsculpt::hull {

using EightIndices = std::uint32_t __attribute__((vector_size(32)));

TETSCULPT_FOUR_LANES inline EightIndices eight_of(const std::uint32_t* indices) {
  EightIndices result;
  std::memcpy(&result, indices, sizeof result);
  return result;
}

TETSCULPT_FOUR_LANES inline EightIndices eight_of(const std::array<std::uint8_t, 8>& small) {
#if defined(__x86_64__)
  const __m128i bytes = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(small.data()));
  return reinterpret_cast<EightIndices>(_mm256_cvtepu8_epi32(bytes));
#else
  EightIndices result;
  for (unsigned i = 0; i < 8; ++i) result[i] = small[i];
  return result;
#endif
}

/// In lane i what was in lane order[i].
TETSCULPT_FOUR_LANES inline EightIndices in_order(const EightIndices& eight,
                                                  const EightIndices& order) {
#if defined(__x86_64__)
  return reinterpret_cast<EightIndices>(_mm256_permutevar8x32_epi32(
      reinterpret_cast<__m256i>(eight), reinterpret_cast<__m256i>(order)));
#else
  EightIndices result;
  for (unsigned i = 0; i < 8; ++i) result[i] = eight[order[i]];
  return result;
#endif
}

TETSCULPT_FOUR_LANES inline EightIndices lesser(const EightIndices& a, const EightIndices& b) {
#if defined(__x86_64__)
  return reinterpret_cast<EightIndices>(
      _mm256_min_epu32(reinterpret_cast<__m256i>(a), reinterpret_cast<__m256i>(b)));
#else
  return a < b ? a : b;
#endif
}

TETSCULPT_FOUR_LANES inline EightIndices greater(const EightIndices& a, const EightIndices& b) {
#if defined(__x86_64__)
  return reinterpret_cast<EightIndices>(
      _mm256_max_epu32(reinterpret_cast<__m256i>(a), reinterpret_cast<__m256i>(b)));
#else
  return a > b ? a : b;
#endif
}

/// A bit per lane whose first bit is set.
TETSCULPT_FOUR_LANES inline unsigned first_bits(const EightIndices& eight) {
#if defined(__x86_64__)
  return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(eight)));
#else
  unsigned result = 0;
  for (unsigned i = 0; i < 8; ++i) result |= eight[i] >> 31 << i;
  return result;
#endif
}

}  // namespace tetsculpt::hull
