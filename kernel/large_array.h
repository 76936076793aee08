#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

/// Arrays with an element per simplex, in memory that the system backs with large pages.
namespace tetsculpt {

/// While one lives, memory of large arrays that are freed on this thread is kept for the next ones
/// instead of going back to the system, which would clear it again. Where several live, the first
/// one counts. Frees what is left when it goes.
class LargeArrayReuse {
 public:
  LargeArrayReuse();
  ~LargeArrayReuse();
  LargeArrayReuse(const LargeArrayReuse&) = delete;
  LargeArrayReuse& operator=(const LargeArrayReuse&) = delete;

 private:
  std::vector<void*> kept_;
  friend void* allocate_large(std::size_t bytes);
  friend void free_large(void* memory) noexcept;
};

/// The size of a large page.
inline constexpr std::size_t kLargePageBytes = std::size_t{2} << 20;
/// How far behind a page's beginning large memory begins, where there are large pages.
inline constexpr std::size_t kLargeArrayOffset = 64;
/// Memory for at least `bytes` bytes, in large pages where the system has them. Throws
/// std::bad_alloc.
void* allocate_large(std::size_t bytes);
void free_large(void* memory) noexcept;
/// Memory for at least `bytes` bytes, more than before, with the first `used` as they are. Frees
/// what they were in. Throws std::bad_alloc, and nothing has changed.
void* grow_large(void* memory, std::size_t used, std::size_t bytes);
/// Frees all but the first `bytes` bytes, where the system can do that.
void shrink_large(void* memory, std::size_t bytes) noexcept;
/// [begin, end) of large memory is about to be used for the first time: in small pages, if the
/// large ones are slow to come. Several threads may do so, each with memory of its own. May change
/// what is there.
void touch_large(void* memory, std::size_t begin, std::size_t end) noexcept;

/// Sizes from which large pages pay; smaller arrays use std::allocator.
inline constexpr std::size_t kLargeArrayBytes = std::size_t{1} << 20;

template <class T>
struct LargePageAllocator {
  using value_type = T;

  LargePageAllocator() = default;
  template <class U>
  explicit(false) LargePageAllocator(const LargePageAllocator<U>&) {}

  T* allocate(std::size_t n) {
    if (n < kLargeArrayBytes / sizeof(T)) return std::allocator<T>().allocate(n);
    return static_cast<T*>(allocate_large(n * sizeof(T)));
  }
  void deallocate(T* memory, std::size_t n) noexcept {
    if (n < kLargeArrayBytes / sizeof(T)) return std::allocator<T>().deallocate(memory, n);
    free_large(memory);
  }
  /// resize(n) and LargeArray(n) leave new elements of plain types as they are, also where members
  /// have values by default: what fills an array needs no zeros before, and each thread touches its
  /// part of the memory first.
  template <class U>
  void construct(U* element) noexcept(std::is_nothrow_default_constructible_v<U>) {
    if constexpr (!std::is_trivially_copyable_v<U>) ::new (static_cast<void*>(element)) U;
  }
  template <class U, class... Arguments>
  void construct(U* element, Arguments&&... arguments) {
    std::construct_at(element, std::forward<Arguments>(arguments)...);
  }
  friend bool operator==(const LargePageAllocator&, const LargePageAllocator&) { return true; }
};

template <class T>
using LargeArray = std::vector<T, LargePageAllocator<T>>;

/// Elements [begin, end) of a new array are about to be set, see touch_large(): none may be yet.
template <class T>
void touch(LargeArray<T>& array, std::size_t begin, std::size_t end) noexcept {
  if (array.capacity() < kLargeArrayBytes / sizeof(T)) return;
  touch_large(array.data(), begin * sizeof(T), end * sizeof(T));
}

}  // namespace tetsculpt
