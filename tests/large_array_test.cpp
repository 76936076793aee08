// Large arrays are vectors, whatever their size and wherever their memory comes from.
#include "kernel/large_array.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <thread>
#include <utility>

#include "kernel/large_block.h"

namespace tetsculpt {
namespace {

constexpr std::size_t kLarge = kLargeArrayBytes / sizeof(std::uint32_t);

TEST_CASE("growing across the limit keeps the contents") {
  LargeArray<std::uint32_t> array;
  for (std::uint32_t k = 0; k < 3 * kLarge; ++k) array.push_back(k);
  for (std::uint32_t k = 0; k < array.size(); ++k) REQUIRE(array[k] == k);
  CHECK(reinterpret_cast<std::uintptr_t>(array.data()) % 64 == 0);
  const LargeArray<std::uint32_t> copy = array;
  CHECK((copy == array));
}

TEST_CASE("while freed memory is kept, the next array gets it") {
  const LargeArrayReuse reuse;
  std::uintptr_t before = 0;
  {
    const LargeArray<std::uint32_t> first(2 * kLarge, 7);
    before = reinterpret_cast<std::uintptr_t>(first.data());
  }
  const LargeArray<std::uint32_t> second(2 * kLarge, 0);
  CHECK(reinterpret_cast<std::uintptr_t>(second.data()) == before);
  for (const std::uint32_t value : second) REQUIRE(value == 0);
  const LargeArray<std::uint32_t> third(2 * kLarge);
  CHECK((third.data() != second.data()));
}

TEST_CASE("arrays may outlive the scope, be freed in another, and on another thread") {
  LargeArray<std::uint32_t> survivor, moved;
  {
    const LargeArrayReuse outer;
    const LargeArrayReuse inner;
    survivor.assign(kLarge, 1);
    moved.assign(kLarge, 2);
  }
  for (const std::uint32_t value : survivor) REQUIRE(value == 1);
  std::thread([array = std::move(moved)]() mutable {
    const LargeArrayReuse other;
    array = LargeArray<std::uint32_t>(kLarge, 3);
  }).join();
  const LargeArrayReuse later;
  survivor = LargeArray<std::uint32_t>();
  CHECK(LargeArray<std::uint32_t>(kLarge, 4).back() == 4);
}

TEST_CASE("what is touched ahead of use leaves what is there before") {
  for (const std::size_t size : {std::size_t{100}, 10 * kLarge, 10 * kLarge + 12'345}) {
    LargeBlock<std::uint32_t> block(size);
    std::size_t used = 0;
    for (const std::size_t next : {size / 100, size / 7, size / 2, size}) {
      block.touch(used, next);
      for (; used < next; ++used) block[used] = static_cast<std::uint32_t>(used);
    }
    block.touch(size, size);
    std::size_t wrong = 0;
    for (std::size_t k = 0; k < size; ++k) wrong += block[k] != k;
    CHECK(wrong == 0);
  }
}

}  // namespace
}  // namespace tetsculpt
