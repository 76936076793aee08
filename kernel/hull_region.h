#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "kernel/hull_facets.h"
#include "kernel/hull_range.h"
#include "kernel/large_block.h"

/// The part of a hull that a point sees. Internal to kernel/lifted_hull.
namespace tetsculpt::hull {

/// A stack that is told ahead how much it may hold, and afterwards how much it does: to fill it
/// takes no more than stores.
template <class T>
class Stack {
 public:
  /// Room for n in all.
  T* room_for(std::size_t n) {
    if (n > room_.capacity()) room_.grow(room_.capacity(), std::max(n, 2 * room_.capacity()));
    return room_.data();
  }
  /// The first n in the room are held.
  void hold(std::size_t n) { size_ = n; }
  std::size_t size() const { return size_; }
  T& operator[](std::size_t k) { return room_[k]; }
  const T& operator[](std::size_t k) const { return room_[k]; }
  const T* begin() const { return room_.data(); }
  const T* end() const { return begin() + size_; }
  std::span<const T> held() const { return {begin(), size_}; }

 private:
  LargeBlock<T> room_;
  std::size_t size_ = 0;
};

/// The facets that an apex sees, and the horizon around them.
struct Region {
  /// Facets, each with the ridge through which it was met.
  Stack<Ridge> visible;
  /// The same, of those that take an exact test; in the end, of those of them that are hidden.
  Stack<Ridge> unclear;
  /// Between a visible facet and one that is not, seen from the former.
  Stack<Ridge> cut;

  /// Takes away the marks.
  void unmark(Facets& facets);
};

/// Fills the region of an apex, from a facet that it sees, and leaves marks on what is visible or
/// unclear. False, and an unfinished region, if it leaves the range. `by_four` only where
/// has_four_lanes().
bool grow_region(Facets& facets, Site apex, FacetIndex seen, const Range& own, bool by_four,
                 Region& region);

}  // namespace tetsculpt::hull
