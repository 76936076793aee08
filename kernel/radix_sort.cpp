// Least-significant-digit radix sort with 11-bit digits; all histograms come from one pass.
#include "kernel/radix_sort.h"

#include <array>
#include <cstddef>
#include <utility>

#include "kernel/large_array.h"

namespace tetsculpt {
namespace {

constexpr int kDigitBits = 11;
constexpr std::size_t kDigits = 6;
constexpr std::size_t kBuckets = std::size_t{1} << kDigitBits;

std::size_t digit(std::uint64_t key, std::size_t d) {
  return (key >> (d * kDigitBits)) & (kBuckets - 1);
}

}  // namespace

void radix_sort(LargeArray<KeyedIndex>& items) {
  if (items.empty()) return;
  std::vector<std::array<std::size_t, kBuckets>> histogram(kDigits);
  for (const KeyedIndex& item : items) {
    for (std::size_t d = 0; d < kDigits; ++d) ++histogram[d][digit(item.key, d)];
  }
  LargeArray<KeyedIndex> other(items.size());
  for (std::size_t d = 0; d < kDigits; ++d) {
    auto& start = histogram[d];
    if (start[digit(items[0].key, d)] == items.size()) continue;
    std::size_t sum = 0;
    for (std::size_t& s : start) sum += std::exchange(s, sum);
    for (const KeyedIndex& item : items) other[start[digit(item.key, d)]++] = item;
    items.swap(other);
  }
}

}  // namespace tetsculpt
