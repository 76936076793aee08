#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#if defined(__x86_64__)
#include <immintrin.h>
/// A function that is only called where has_four_lanes().
#define TETSCULPT_FOUR_LANES [[gnu::target("avx2,fma,popcnt")]]
#else
#define TETSCULPT_FOUR_LANES
#endif

/// Four numbers at a time, in vectors of GCC's and Clang's extension, the same on all processors.
/// Internal to kernel/lifted_hull and kernel/simplices.
namespace tetsculpt::hull {

/// Whether this build and this processor can take four doubles at a time: AVX2 and FMA.
bool has_four_lanes();

using Four = double __attribute__((vector_size(32)));
using FourLongs = std::int64_t __attribute__((vector_size(32)));
using FourBits = std::uint64_t __attribute__((vector_size(32)));
using FourIndices = std::uint32_t __attribute__((vector_size(16)));

inline FourIndices four_of(const std::uint32_t* indices) {
  FourIndices result;
  std::memcpy(&result, indices, sizeof result);
  return result;
}

/// In lane i what was in lane order[i].
TETSCULPT_FOUR_LANES inline FourIndices in_order(const FourIndices& four,
                                                 const std::array<std::uint32_t, 4>& order) {
#if defined(__x86_64__)
  const auto lanes = reinterpret_cast<__m128i>(four_of(order.data()));
  return reinterpret_cast<FourIndices>(_mm_permutevar_ps(reinterpret_cast<__m128>(four), lanes));
#else
  return FourIndices{four[order[0]], four[order[1]], four[order[2]], four[order[3]]};
#endif
}

/// A bit per lane whose first bit is set.
inline unsigned first_bits(const FourIndices& four) {
#if defined(__x86_64__)
  return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(four)));
#else
  return four[0] >> 31 | four[1] >> 31 << 1 | four[2] >> 31 << 2 | four[3] >> 31 << 3;
#endif
}
TETSCULPT_FOUR_LANES inline unsigned first_bits(const Four& four) {
#if defined(__x86_64__)
  return static_cast<unsigned>(_mm256_movemask_pd(four));
#else
  const auto bits = reinterpret_cast<FourBits>(four);
  unsigned result = 0;
  for (unsigned i = 0; i < 4; ++i) result |= static_cast<unsigned>(bits[i] >> 63) << i;
  return result;
#endif
}

}  // namespace tetsculpt::hull
