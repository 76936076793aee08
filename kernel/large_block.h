#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#include "kernel/large_array.h"
#include "kernel/parallel.h"

namespace tetsculpt {

/// Room for elements of a plain type, in the memory of large arrays, that can be cut short in
/// place. Elements are not initialised, and room that is never touched costs next to nothing.
template <class T>
class LargeBlock {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= 64);

 public:
  LargeBlock() = default;
  explicit LargeBlock(std::size_t capacity)
      : large_(capacity * sizeof(T) >= kLargeArrayBytes),
        capacity_(capacity),
        data_(static_cast<T*>(large_ ? allocate_large(capacity * sizeof(T))
                                     : ::operator new(capacity * sizeof(T), kAlignment))) {}
  LargeBlock(LargeBlock&& other) noexcept { *this = std::move(other); }
  LargeBlock& operator=(LargeBlock&& other) noexcept {
    std::swap(large_, other.large_);
    std::swap(capacity_, other.capacity_);
    std::swap(data_, other.data_);
    return *this;
  }
  ~LargeBlock() {
    if (!data_) return;
    if (large_) {
      free_large(data_);
    } else {
      ::operator delete(data_, kAlignment);
    }
  }

  std::size_t capacity() const { return capacity_; }
  /// Null if there is no room.
  T* data() { return data_; }
  const T* data() const { return data_; }
  T& operator[](std::size_t k) { return data_[k]; }
  const T& operator[](std::size_t k) const { return data_[k]; }

  /// Moves the first `used` elements to a block with more room.
  void grow(std::size_t used, std::size_t capacity) {
    if (large_) {
      data_ = static_cast<T*>(grow_large(data_, used * sizeof(T), capacity * sizeof(T)));
      capacity_ = capacity;
      return;
    }
    LargeBlock larger(capacity);
    if (used > 0) std::memcpy(larger.data_, data_, used * sizeof(T));
    *this = std::move(larger);
  }

  /// Those of [begin, end) are used next, for the first time.
  void touch(std::size_t begin, std::size_t end) {
    if (large_) touch_large(data_, begin * sizeof(T), end * sizeof(T));
  }

  /// Of the first `count` elements one member, one behind the other in the same memory; lets go of
  /// the rest. On up to `threads` threads; each(thread) gives what is called with every one of that
  /// thread's, see reduced_ranges().
  template <class Part, class Whole, class Each>
  LargeBlock<Part> reduced_to(Part Whole::*part, std::size_t count, int threads, Each&& each) && {
    static_assert(std::is_same_v<Whole, T> && 2 * sizeof(Part) <= sizeof(T));
    for (std::size_t begin = 0; begin < count; begin = reduced_at_once(begin, count)) {
      const std::vector<std::size_t> cuts = reduced_cuts(begin, count, threads);
      parallel_each(cuts.size() - 1, [&](std::size_t thread) {
        move_parts(data_, part, cuts[thread], cuts[thread + 1], each(thread));
      });
    }
    LargeBlock<Part> parts;
    parts.large_ = large_;
    parts.capacity_ = count;
    parts.data_ = reinterpret_cast<Part*>(std::exchange(data_, nullptr));
    if (large_) shrink_large(parts.data_, count * sizeof(Part));
    return parts;
  }

  /// What reduced_to() gives to one of its threads: calls range(begin, end).
  template <class Range>
  static void reduced_ranges(std::size_t count, int threads, std::size_t thread, Range&& range) {
    for (std::size_t begin = 0; begin < count; begin = reduced_at_once(begin, count)) {
      const std::vector<std::size_t> cuts = reduced_cuts(begin, count, threads);
      if (thread + 1 < cuts.size()) range(cuts[thread], cuts[thread + 1]);
    }
  }

 private:
  template <class>
  friend class LargeBlock;

  /// Twice as many each time: [begin, 2 begin) go where those were that went before.
  static std::size_t reduced_at_once(std::size_t begin, std::size_t count) {
    return begin == 0 ? 1 : std::min(2 * begin, count);
  }
  static std::vector<std::size_t> reduced_cuts(std::size_t begin, std::size_t count, int threads) {
    std::vector<std::size_t> cuts = range_cuts(reduced_at_once(begin, count) - begin, threads);
    for (std::size_t& cut : cuts) cut += begin;
    return cuts;
  }

  /// What it works with is on the thread's own stack: what one thread reads all the time must not
  /// share a cache line with what another one writes.
  template <class Part, class Whole, class Each>
  static void move_parts(Whole* from, Part Whole::*part, std::size_t begin, std::size_t end,
                         Each each) {
    auto* const to = reinterpret_cast<std::byte*>(from);
    for (std::size_t k = begin; k < end; ++k) {
      const Part copy = from[k].*part;
      std::memcpy(to + k * sizeof(Part), &copy, sizeof(Part));
      each(copy);
    }
  }

  static constexpr std::align_val_t kAlignment{64};

  bool large_ = false;
  std::size_t capacity_ = 0;
  T* data_ = nullptr;
};

}  // namespace tetsculpt
