// radix_sort is a stable sort by key.
#include "kernel/radix_sort.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

std::size_t differences_from_stable_sort(LargeArray<KeyedIndex> items, int threads = 1) {
  LargeArray<KeyedIndex> expected = items;
  std::stable_sort(expected.begin(), expected.end(),
                   [](const KeyedIndex& a, const KeyedIndex& b) { return a.key < b.key; });
  radix_sort(items, threads);
  REQUIRE(items.size() == expected.size());
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    wrong += items[i].key != expected[i].key || items[i].index != expected[i].index;
  }
  return wrong;
}

TEST_CASE("the same as a stable sort, whichever bits the keys use") {
  for (const std::uint64_t mask :
       {~0ull, 0ull, 0x7ffull, 0xffull << 56, 1ull << 63, 0x8000000000000001ull, 0x3ull << 10,
        0xffffffffull, 0xffffffff00000000ull}) {
    for (const std::size_t n : {0u, 1u, 2u, 3u, 100u, 5000u}) {
      const std::uint64_t seed = n + 1;
      point_sets::Random random(seed);
      LargeArray<KeyedIndex> items(n);
      for (std::uint32_t i = 0; i < n; ++i) items[i] = {random.bits() & mask, i};
      CAPTURE(mask);
      CAPTURE(seed);
      CHECK(differences_from_stable_sort(items) == 0);
    }
  }
}

TEST_CASE("numbers") {
  for (const int threads : {1, 2, 3}) {
    point_sets::Random random(7);
    LargeArray<std::uint64_t> numbers(20000);
    for (std::uint64_t& n : numbers) n = random.bits() >> random.below(64);
    LargeArray<std::uint64_t> expected = numbers;
    std::ranges::sort(expected);
    radix_sort(numbers, threads);
    CHECK(numbers == expected);
  }
}

TEST_CASE("sorted and reversed keys") {
  LargeArray<KeyedIndex> items;
  for (std::uint32_t i = 0; i < 3000; ++i) items.push_back({std::uint64_t{i} << 20, i});
  CHECK(differences_from_stable_sort(items) == 0);
  std::reverse(items.begin(), items.end());
  CHECK(differences_from_stable_sort(items) == 0);
}

TEST_CASE("keys that agree in their high bits, few and many at a time") {
  for (const std::uint64_t kinds : {2u, 40u, 2000u}) {
    const std::uint64_t seed = kinds;
    point_sets::Random random(seed);
    LargeArray<KeyedIndex> items(5000);
    for (std::uint32_t i = 0; i < items.size(); ++i) {
      items[i] = {random.bits() % kinds << 52 | random.bits() % 1000, i};
    }
    CAPTURE(seed);
    CHECK(differences_from_stable_sort(items) == 0);
  }
}

TEST_CASE("on several threads, keys spread evenly or not, digits left out") {
  for (const std::uint64_t mask : {~0ull, 0ull, 0x3ull << 30, 0x7ffull << 40, 0xff00000000ffull}) {
    const std::uint64_t seed = 8;
    point_sets::Random random(seed);
    LargeArray<KeyedIndex> items(20000);
    for (std::uint32_t i = 0; i < items.size(); ++i) {
      items[i] = {(i % 3 == 0 ? random.bits() : random.bits() >> 20) & mask, i};
    }
    CAPTURE(mask);
    for (const int threads : {2, 3, 7}) CHECK(differences_from_stable_sort(items, threads) == 0);
  }
}

}  // namespace
}  // namespace tetsculpt
