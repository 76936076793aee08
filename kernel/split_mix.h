#pragma once

#include <cstdint>

/// Pseudo-random numbers that are the same on every platform.
namespace tetsculpt {

/// SplitMix64: a well mixed function of x, and with split_mix_next a sequence. [Steele, Lea, Flood
/// 2014]
constexpr std::uint64_t split_mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

/// The next number of the sequence whose state this is.
constexpr std::uint64_t split_mix_next(std::uint64_t& state) {
  const std::uint64_t next = split_mix(state);
  state += 0x9e3779b97f4a7c15ull;
  return next;
}

}  // namespace tetsculpt
