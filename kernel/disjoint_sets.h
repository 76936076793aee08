#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "kernel/large_array.h"

/// Disjoint sets with union by size and path halving.
namespace tetsculpt {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n), size_(n, 1) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::uint32_t find(std::size_t x) {
    auto i = static_cast<std::uint32_t>(x);
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  /// True if a and b were in different sets, which are one now.
  bool unite(std::size_t a, std::size_t b) {
    std::uint32_t ra = find(a);
    std::uint32_t rb = find(b);
    if (ra == rb) return false;
    if (size_[ra] < size_[rb]) std::swap(ra, rb);
    parent_[rb] = ra;
    size_[ra] += size_[rb];
    return true;
  }

 private:
  LargeArray<std::uint32_t> parent_;
  LargeArray<std::uint32_t> size_;
};

}  // namespace tetsculpt
