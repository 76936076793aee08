#pragma once

#include <cstdint>

#include "kernel/large_array.h"

/// Sorting by 64-bit keys, in linear time where few agree in their high bits.
namespace tetsculpt {

struct KeyedIndex {
  std::uint64_t key;
  std::uint32_t index;
};

/// Sorts by key, stably. Digits that are the same in all keys cost no pass.
/// Cost: at most three passes, and m log m comparisons for m keys that agree in the 33 bits from
/// the highest one down that differs anywhere; memory for a second copy. On up to `threads`
/// threads, each of which takes a range of keys, for one pass more.
void radix_sort(LargeArray<KeyedIndex>& items, int threads = 1);
/// The same for numbers.
void radix_sort(LargeArray<std::uint64_t>& items, int threads = 1);

}  // namespace tetsculpt
