#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

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
  T& operator[](std::size_t k) { return data_[k]; }
  const T& operator[](std::size_t k) const { return data_[k]; }

  /// Moves the first `used` elements to a block with more room.
  void grow(std::size_t used, std::size_t capacity) {
    LargeBlock larger(capacity);
    if (used > 0) std::memcpy(larger.data_, data_, used * sizeof(T));
    *this = std::move(larger);
  }

  /// Of the first `count` elements one member, one behind the other in the same memory; lets go of
  /// the rest. On up to `threads` threads, each(thread, part) is called with every one.
  template <class Part, class Whole, class Each>
  LargeBlock<Part> reduced_to(Part Whole::*part, std::size_t count, int threads, Each&& each) && {
    static_assert(std::is_same_v<Whole, T> && 2 * sizeof(Part) <= sizeof(T));
    auto* const bytes = reinterpret_cast<std::byte*>(data_);
    // Twice as many each time: [begin, 2 begin) go where those were that went before.
    std::size_t end = 0;
    for (std::size_t begin = 0; begin < count; begin = end) {
      end = begin == 0 ? 1 : std::min(2 * begin, count);
      const std::size_t parts = worth_threads(end - begin, threads);
      const auto cut = [&](std::size_t thread) { return begin + (end - begin) * thread / parts; };
      parallel_each(parts, [&](std::size_t thread) {
        for (std::size_t k = cut(thread); k < cut(thread + 1); ++k) {
          const Part copy = data_[k].*part;
          std::memcpy(bytes + k * sizeof(Part), &copy, sizeof(Part));
          each(thread, copy);
        }
      });
    }
    LargeBlock<Part> parts;
    parts.large_ = large_;
    parts.capacity_ = count;
    parts.data_ = reinterpret_cast<Part*>(std::exchange(data_, nullptr));
    if (large_) shrink_large(parts.data_, count * sizeof(Part));
    return parts;
  }

 private:
  template <class>
  friend class LargeBlock;
  static constexpr std::align_val_t kAlignment{64};

  bool large_ = false;
  std::size_t capacity_ = 0;
  T* data_ = nullptr;
};

}  // namespace tetsculpt
