#pragma once

#include <cstdint>

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

}  // namespace tetsculpt
