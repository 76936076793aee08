// The kernel of Linux hands out memory in pages of 4 KiB, and on most systems uses 2 MiB ones only
// where a program asks for them. A million points make arrays of gigabytes: a page fault per 4 KiB
// of them, and address translations that miss the TLB at each step of a walk. Measured on a virtual
// machine: the hull of 65,536 points of the bumpy sphere in 0.25 s instead of 0.47 s, of a million
// in 5.3 s instead of 12.6 s. Clearing the pages is what remains, a nanosecond per byte there;
// keeping freed memory within one reconstruction takes a quarter off all that follows the hull.
//
// A host may take back what is free on its virtual machines. There, some seconds later, a large
// page takes 8 ms to come instead of 0.3, while 500 MB in small ones still take 0.25 s: the hull of
// a million points of a cube took 3.0 to 4.3 s with large pages and 1.7 to 2.6 with small ones,
// where in memory just freed it takes 1.5 and 1.8. So the first touch of each large page is timed.
//     What grows is moved by its addresses: the facets of a million points of a torus, which are
// more than was reserved, took 2.4 GB while they were copied, and take 1.4.
#include "kernel/large_array.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>

#include <ctime>
#endif

namespace tetsculpt {
namespace {

constexpr std::size_t kPage = kLargePageBytes;
/// In front of every array.
struct Header {
  std::size_t block_size;
  std::atomic<bool> small_pages;  ///< asked for
};
/// Its size, and room to keep the array's alignment.
constexpr std::size_t kHeader = kLargeArrayOffset;
static_assert(sizeof(Header) <= kHeader);
[[maybe_unused]] constexpr std::align_val_t kAlignment{kHeader};

/// Whether a large page took too long to come: then no more are asked for, until some thread begins
/// another reconstruction.
std::atomic<bool> too_slow = false;

/// Only a place to keep memory, of this thread alone.
thread_local LargeArrayReuse* reuse = nullptr;

Header& header_of(void* block) { return *static_cast<Header*>(block); }
std::size_t& size_of(void* block) { return header_of(block).block_size; }
/// Where a block begins, or what is behind one that is cut.
void set_header(void* block, std::size_t bytes) { ::new (block) Header{bytes, false}; }

#if __has_include(<sys/mman.h>)

/// Pages can be given back one by one: a block may be cut in two.
constexpr bool kDivisible = true;

void give_back(void* block, std::size_t bytes) noexcept { munmap(block, bytes); }

#ifdef MADV_HUGEPAGE

/// This thread's processor time, which goes on while a host finds memory.
std::chrono::nanoseconds processor_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

/// Uses a page for the first time.
void touch(void* page) {
  constexpr std::chrono::milliseconds kLongest{2};  // some five times as long as to clear it
  const auto start = processor_time();
  *static_cast<volatile char*>(page) = 0;
  if (processor_time() - start > kLongest) too_slow = true;
}

#endif

/// Addresses from the beginning of a page on.
void* map_pages(std::size_t bytes) {
  // A page more, to cut off what is not aligned.
  void* const mapped =
      mmap(nullptr, bytes + kPage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) throw std::bad_alloc();
  const std::size_t ahead = kPage - reinterpret_cast<std::uintptr_t>(mapped) % kPage;
  char* const block = static_cast<char*>(mapped) + ahead;
  give_back(mapped, ahead);
  if (ahead != kPage) give_back(block + bytes, kPage - ahead);
  return block;
}

void* new_block(std::size_t bytes) {
  void* const block = map_pages(bytes);
#ifdef MADV_HUGEPAGE
  if (!too_slow) {
    madvise(block, bytes, MADV_HUGEPAGE);  // a wish that the system may ignore
    touch(block);
  }
  if (too_slow) madvise(block, bytes, MADV_NOHUGEPAGE);
#endif
  set_header(block, bytes);
  return block;
}

/// The pages of a block at other addresses, and more behind them; null if they can't go there.
void* moved_block([[maybe_unused]] void* block, [[maybe_unused]] std::size_t bytes) {
#ifdef MREMAP_FIXED
  void* const target = map_pages(bytes);
  constexpr int kThere = MREMAP_MAYMOVE | MREMAP_FIXED;
  if (mremap(block, size_of(block), bytes, kThere, target) != MAP_FAILED) {
    size_of(target) = bytes;
    return target;
  }
  give_back(target, bytes);
#endif
  return nullptr;
}

#else

constexpr bool kDivisible = false;

void give_back(void* block, std::size_t) noexcept { ::operator delete(block, kAlignment); }

void* new_block(std::size_t bytes) {
  void* const block = ::operator new(bytes, kAlignment);
  set_header(block, bytes);
  return block;
}

void* moved_block(void*, std::size_t) { return nullptr; }

#endif

/// The smallest kept block that is large enough, less what is not needed of it; else null.
void* take_kept(std::vector<void*>& kept, std::size_t bytes) {
  auto best = kept.end();
  for (auto it = kept.begin(); it != kept.end(); ++it) {
    if (size_of(*it) < bytes) continue;
    if (best == kept.end() || size_of(*it) < size_of(*best)) best = it;
  }
  if (best == kept.end()) return nullptr;
  void* const block = *best;
  const std::size_t rest = size_of(block) - bytes;
  if (kDivisible && rest > 0) {
    *best = static_cast<char*>(block) + bytes;
    set_header(*best, rest);
    size_of(block) = bytes;
  } else {
    *best = kept.back();
    kept.pop_back();
  }
  return block;
}

/// Makes one of a block and those that are kept on either side of it.
void* merged(std::vector<void*>& kept, void* block) noexcept {
  if (!kDivisible) return block;
  for (std::size_t k = 0; k < kept.size();) {
    char* const other = static_cast<char*>(kept[k]);
    char* const mine = static_cast<char*>(block);
    if (other + size_of(other) != mine && mine + size_of(mine) != other) {
      ++k;
      continue;
    }
    const std::size_t sum = size_of(other) + size_of(mine);
    block = std::min(other, mine);
    set_header(block, sum);
    kept[k] = kept.back();
    kept.pop_back();
  }
  return block;
}

std::size_t block_size(std::size_t bytes) { return (kHeader + bytes + kPage - 1) / kPage * kPage; }

}  // namespace

void touch_large([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t begin,
                 [[maybe_unused]] std::size_t end) noexcept {
#if defined(MADV_HUGEPAGE)
  char* const block = static_cast<char*>(memory) - kHeader;  // where a page begins
  const std::size_t block_end = kHeader + end;
  std::size_t at = (kHeader + begin + kPage - 1) / kPage * kPage;
  for (; at < block_end && !too_slow; at += kPage) touch(block + at);
  if (!too_slow) return;
  // Once, because other threads' pages wait for that.
  if (!header_of(block).small_pages.exchange(true)) {
    madvise(block, size_of(block), MADV_NOHUGEPAGE);
  }
#if defined(MADV_POPULATE_WRITE)
  if (at < block_end) madvise(block + at, block_end - at, MADV_POPULATE_WRITE);
#endif
#endif
}

LargeArrayReuse::LargeArrayReuse() {
  if (reuse) return;
  reuse = this;
  too_slow = false;
}

LargeArrayReuse::~LargeArrayReuse() {
  if (reuse == this) reuse = nullptr;
  for (void* const block : kept_) give_back(block, size_of(block));
}

void* allocate_large(std::size_t bytes) {
  if (bytes > std::numeric_limits<std::size_t>::max() / 4) throw std::bad_alloc();
  const std::size_t size = block_size(bytes);
  void* block = reuse ? take_kept(reuse->kept_, size) : nullptr;
  if (!block) block = new_block(size);
  return static_cast<char*>(block) + kHeader;
}

void free_large(void* memory) noexcept {
  void* block = static_cast<char*>(memory) - kHeader;
  if (!reuse) return give_back(block, size_of(block));
  block = merged(reuse->kept_, block);
  try {
    reuse->kept_.push_back(block);
  } catch (const std::bad_alloc&) {
    give_back(block, size_of(block));
  }
}

void* grow_large(void* memory, std::size_t used, std::size_t bytes) {
  void* const moved = moved_block(static_cast<char*>(memory) - kHeader, block_size(bytes));
  if (moved) return static_cast<char*>(moved) + kHeader;
  void* const larger = allocate_large(bytes);
  std::memcpy(larger, memory, used);
  free_large(memory);
  return larger;
}

void shrink_large(void* memory, std::size_t bytes) noexcept {
  char* const block = static_cast<char*>(memory) - kHeader;
  const std::size_t size = block_size(bytes);
  if (!kDivisible || size >= size_of(block)) return;
  set_header(block + size, size_of(block) - size);
  size_of(block) = size;
  free_large(block + size + kHeader);
}

}  // namespace tetsculpt
