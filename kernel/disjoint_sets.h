#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "kernel/large_array.h"

/// Disjoint sets with path halving. The representative of a set is its smallest member: with
/// members numbered by place, trees stay shallow without a second array for sizes or ranks.
namespace tetsculpt {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  /// Room for n members, each of which is in no set before make_set(). Threads whose members have
  /// no set in common may make sets and unite them at the same time.
  static DisjointSets room_for(std::size_t n) {
    DisjointSets sets(0);
    sets.parent_.resize(n);
    return sets;
  }

  void make_set(std::uint32_t x) { parent_[x] = x; }

  std::uint32_t find(std::size_t x) {
    auto i = static_cast<std::uint32_t>(x);
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  /// True if a and b were in different sets, which are one now.
  bool unite(std::size_t a, std::size_t b) {
    const std::uint32_t ra = find(a);
    const std::uint32_t rb = find(b);
    if (ra == rb) return false;
    parent_[std::max(ra, rb)] = std::min(ra, rb);
    return true;
  }

  /// The same where other threads do so, too, and nobody does anything else.
  bool unite_concurrently(std::uint32_t a, std::uint32_t b) {
    for (;;) {
      a = find_concurrently(a);
      b = find_concurrently(b);
      if (a == b) return false;
      if (a < b) std::swap(a, b);
      std::uint32_t root = a;
      if (parent(a).compare_exchange_weak(root, b, std::memory_order_relaxed)) return true;
    }
  }

  /// Per member a smaller one of its set; itself if it is the smallest.
  LargeArray<std::uint32_t> take_parents() && { return std::move(parent_); }

 private:
  std::atomic_ref<std::uint32_t> parent(std::uint32_t x) { return std::atomic_ref(parent_[x]); }
  /// What is the smallest member, until some other thread unites its set with another.
  std::uint32_t find_concurrently(std::uint32_t x) {
    for (;;) {
      const std::uint32_t above = parent(x).load(std::memory_order_relaxed);
      const std::uint32_t next = parent(above).load(std::memory_order_relaxed);
      if (next == above) return above;
      // Others may have put a smaller one there; this one is in the set as well.
      parent(x).store(next, std::memory_order_relaxed);
      x = next;
    }
  }

  LargeArray<std::uint32_t> parent_;
};

}  // namespace tetsculpt
