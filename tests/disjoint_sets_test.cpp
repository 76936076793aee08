// Disjoint sets are the classes of the pairs united so far.
#include "kernel/disjoint_sets.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/parallel.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

TEST_CASE("each item is its own set at first") {
  DisjointSets sets(4);
  for (std::size_t i = 0; i < 4; ++i) CHECK(sets.find(i) == i);
}

TEST_CASE("unite says whether two sets became one") {
  DisjointSets sets(5);
  CHECK(sets.unite(0, 1));
  CHECK(sets.unite(2, 3));
  CHECK_FALSE(sets.unite(1, 0));
  CHECK_FALSE(sets.unite(4, 4));
  CHECK(sets.unite(3, 0));
  CHECK_FALSE(sets.unite(1, 2));
  CHECK(sets.find(0) == sets.find(3));
  CHECK(sets.find(0) != sets.find(4));
}

TEST_CASE("sets made one by one, and the parents they leave") {
  DisjointSets sets = DisjointSets::room_for(6);
  for (const std::uint32_t x : {4u, 1u, 2u, 5u}) sets.make_set(x);
  CHECK(sets.unite(5, 2));
  CHECK(sets.unite(4, 5));
  CHECK(sets.find(4) == 2);
  const auto parents = std::move(sets).take_parents();
  REQUIRE(parents.size() == 6);
  CHECK(parents[1] == 1);
  CHECK(parents[2] == 2);
  CHECK((parents[4] == 2 && parents[5] == 2));
}

TEST_CASE("the same classes as relabelling by hand") {
  constexpr std::size_t kItems = 200;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    point_sets::Random random(seed);
    DisjointSets sets(kItems);
    std::vector<std::size_t> label(kItems);
    for (std::size_t i = 0; i < kItems; ++i) label[i] = i;
    std::size_t wrong = 0;
    for (int step = 0; step < 250; ++step) {
      const std::size_t a = random.below(kItems);
      const std::size_t b = random.below(kItems);
      wrong += sets.unite(a, b) != (label[a] != label[b]);
      std::replace(label.begin(), label.end(), std::size_t{label[b]}, std::size_t{label[a]});
    }
    for (std::size_t i = 0; i < kItems; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        wrong += (sets.find(i) == sets.find(j)) != (label[i] == label[j]);
      }
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("several threads at once make the classes that one makes") {
  constexpr std::size_t kItems = 20000;
  constexpr std::size_t kThreads = 4;
  for (const std::size_t reach : {3u, 100u, 20000u}) {  // few sets, or one that all threads change
    CAPTURE(reach);
    point_sets::Random random(reach);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs(kItems);
    for (auto& [a, b] : pairs) {
      a = static_cast<std::uint32_t>(random.below(kItems));
      b = static_cast<std::uint32_t>((a + random.below(reach)) % kItems);
    }
    DisjointSets one(kItems);
    std::size_t united = 0;
    for (const auto& [a, b] : pairs) united += one.unite(a, b);
    DisjointSets many(kItems);
    std::atomic<std::size_t> united_by_many = 0;
    parallel_each(kThreads, [&](std::size_t thread) {
      for (std::size_t k = thread; k < pairs.size(); k += kThreads) {
        united_by_many += many.unite_concurrently(pairs[k].first, pairs[k].second);
      }
    });
    CHECK(united_by_many == united);
    std::size_t wrong = 0;
    for (std::size_t x = 0; x < kItems; ++x) wrong += many.find(x) != one.find(x);
    CHECK(wrong == 0);
    const auto parents = std::move(many).take_parents();
    for (std::uint32_t x = 0; x < kItems; ++x) wrong += parents[x] > x;
    CHECK(wrong == 0);
  }
}

TEST_CASE("a long chain, from either end") {
  constexpr std::size_t kItems = 100000;
  DisjointSets up(kItems);
  DisjointSets down(kItems);
  for (std::size_t i = 1; i < kItems; ++i) {
    up.unite(i - 1, i);
    down.unite(kItems - i, kItems - i - 1);
  }
  CHECK(up.find(0) == up.find(kItems - 1));
  CHECK(down.find(0) == down.find(kItems - 1));
}

}  // namespace
}  // namespace tetsculpt
