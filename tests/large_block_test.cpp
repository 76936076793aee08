// A block cut down to one member of its elements holds that of each, in their order.
#include "kernel/large_block.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace tetsculpt {
namespace {

struct Part {
  std::uint64_t a = 0;
  std::uint64_t b = 0;
};

struct Whole {
  std::uint64_t before = 0;
  Part part;
  std::uint64_t after = 0;
};

/// Element k holds these; so that a part in a wrong place is seen.
Whole whole(std::uint64_t k) { return {7 * k, {3 * k + 1, ~k}, 11 * k}; }

/// How many parts are wrong, or were not passed to exactly one thread once.
std::size_t wrong_parts(std::size_t count, int threads) {
  LargeBlock<Whole> block(count + 5);
  for (std::size_t k = 0; k < count; ++k) block[k] = whole(k);
  std::vector<std::vector<int>> seen(static_cast<std::size_t>(threads), std::vector<int>(count, 0));
  const LargeBlock<Part> parts =
      std::move(block).reduced_to(&Whole::part, count, threads, [&](std::size_t thread) {
        return [&of_thread = seen[thread]](const Part& p) { ++of_thread[(p.a - 1) / 3]; };
      });
  REQUIRE(parts.capacity() == count);
  std::size_t wrong = 0;
  for (std::size_t thread = 0; thread < seen.size(); ++thread) {
    std::vector<int> expected(count, 0);
    LargeBlock<Whole>::reduced_ranges(count, threads, thread,
                                      [&](std::size_t begin, std::size_t end) {
                                        for (std::size_t k = begin; k < end; ++k) expected[k] = 1;
                                      });
    wrong += seen[thread] != expected;
  }
  for (std::size_t k = 0; k < count; ++k) {
    int times = 0;
    for (const auto& of_thread : seen) times += of_thread[k];
    const Part expected = whole(k).part;
    wrong += parts[k].a != expected.a || parts[k].b != expected.b || times != 1;
  }
  return wrong;
}

TEST_CASE("few elements, and so many that threads share them") {
  for (const int threads : {1, 2, 3}) {
    CAPTURE(threads);
    for (const std::size_t count : {0u, 1u, 2u, 3u, 100u, 4096u, 60000u, 100001u}) {
      CAPTURE(count);
      CHECK(wrong_parts(count, threads) == 0);
    }
  }
}

TEST_CASE("growing keeps what is used") {
  LargeBlock<Whole> block(10);
  std::size_t used = 10;
  for (std::size_t k = 0; k < used; ++k) block[k] = whole(k);
  for (const std::size_t capacity :
       {1'000u, 100'000u, 150'000u, 700'000u}) {  // large from the second
    CAPTURE(capacity);
    block.grow(used, capacity);
    REQUIRE(block.capacity() == capacity);
    CHECK(reinterpret_cast<std::uintptr_t>(block.data()) % 64 == 0);
    for (; used < capacity; ++used) block[used] = whole(used);
    std::size_t wrong = 0;
    for (std::size_t k = 0; k < used; ++k) wrong += block[k].part.b != whole(k).part.b;
    CHECK(wrong == 0);
  }
}

TEST_CASE("a block that grows may be a part of memory that is kept, and others' next to it") {
  constexpr std::size_t kPage = kLargePageBytes / sizeof(std::uint64_t);
  const LargeArrayReuse reuse;
  { const LargeBlock<std::uint64_t> all(20 * kPage); }  // its memory is shared out
  std::vector<LargeBlock<std::uint64_t>> blocks;
  std::vector<std::size_t> sizes;
  const auto fill = [&](std::size_t b, std::size_t begin) {
    for (std::size_t k = begin; k < sizes[b]; ++k) blocks[b][k] = 1000 * k + b;
  };
  for (std::size_t b = 0; b < 4; ++b) {
    sizes.push_back((b + 1) * kPage);
    blocks.emplace_back(sizes[b]);
    fill(b, 0);
  }
  for (const std::size_t b : {1u, 0u, 3u, 1u, 2u, 0u}) {
    const std::size_t before = std::exchange(sizes[b], 3 * sizes[b]);
    blocks[b].grow(before, sizes[b]);
    fill(b, before);
  }
  std::size_t wrong = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (std::size_t k = 0; k < sizes[b]; ++k) wrong += blocks[b][k] != 1000 * k + b;
  }
  CHECK(wrong == 0);
}

}  // namespace
}  // namespace tetsculpt
