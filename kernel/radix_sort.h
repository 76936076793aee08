#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "kernel/large_array.h"

/// Sorting by 64-bit keys in linear time.
namespace tetsculpt {

struct KeyedIndex {
  std::uint64_t key;
  std::uint32_t index;
};

/// Sorts by key, stably. Digits that are the same in all keys cost nothing.
/// Cost: at most six passes; memory for a second copy.
void radix_sort(LargeArray<KeyedIndex>& items);

/// A key that sorts as the double does; -0.0 and 0.0 get the same.
inline std::uint64_t ordered_bits(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x + 0.0);
  constexpr std::uint64_t kSign = 1ull << 63;
  return bits & kSign ? ~bits : bits | kSign;
}

}  // namespace tetsculpt
