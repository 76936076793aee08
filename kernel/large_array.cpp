// The kernel of Linux hands out memory in pages of 4 KiB, and on most systems uses 2 MiB ones only
// where a program asks for them. A million points make arrays of gigabytes: a page fault per 4 KiB
// of them, and address translations that miss the TLB at each step of a walk. Measured on a virtual
// machine: the hull of 65,536 points of the bumpy sphere in 0.25 s instead of 0.47 s, of a million
// in 5.3 s instead of 12.6 s. Clearing the pages is what remains, a nanosecond per byte there;
// keeping freed memory within one reconstruction takes a quarter off all that follows the hull.
#include "kernel/large_array.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <new>

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

namespace tetsculpt {
namespace {

constexpr std::size_t kPage = std::size_t{2} << 20;
/// In front of every array: the size of its block, and room to keep the array's alignment.
constexpr std::size_t kHeader = 64;

/// Only a place to keep memory, of this thread alone.
thread_local LargeArrayReuse* reuse = nullptr;

std::size_t& size_of(void* block) { return *static_cast<std::size_t*>(block); }

/// A wish that the system may ignore.
void ask_for_large_pages([[maybe_unused]] void* block, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  madvise(block, bytes, MADV_HUGEPAGE);
#endif
}

void* new_block(std::size_t bytes) {
  void* const block = std::aligned_alloc(kPage, bytes);
  if (!block) throw std::bad_alloc();
  ask_for_large_pages(block, bytes);
  size_of(block) = bytes;
  return block;
}

/// The smallest kept block that is large enough, unless much of it would lie idle; else null.
void* take_kept(std::vector<void*>& kept, std::size_t bytes) {
  auto best = kept.end();
  for (auto it = kept.begin(); it != kept.end(); ++it) {
    if (size_of(*it) < bytes || size_of(*it) > 2 * bytes + kPage) continue;
    if (best == kept.end() || size_of(*it) < size_of(*best)) best = it;
  }
  if (best == kept.end()) return nullptr;
  void* const block = *best;
  *best = kept.back();
  kept.pop_back();
  return block;
}

}  // namespace

LargeArrayReuse::LargeArrayReuse() {
  if (!reuse) reuse = this;
}

LargeArrayReuse::~LargeArrayReuse() {
  if (reuse == this) reuse = nullptr;
  for (void* const block : kept_) std::free(block);
}

void* allocate_large(std::size_t bytes) {
  if (bytes > std::numeric_limits<std::size_t>::max() / 4) throw std::bad_alloc();
  const std::size_t size = (kHeader + bytes + kPage - 1) / kPage * kPage;
  void* block = reuse ? take_kept(reuse->kept_, size) : nullptr;
  if (!block) block = new_block(size);
  return static_cast<char*>(block) + kHeader;
}

void free_large(void* memory) noexcept {
  void* const block = static_cast<char*>(memory) - kHeader;
  if (!reuse) return std::free(block);
  try {
    reuse->kept_.push_back(block);
  } catch (const std::bad_alloc&) {
    std::free(block);
  }
}

}  // namespace tetsculpt
