// Both queues of the paper's method give entries back smallest key first, equal keys in the
// lexicographic order of corners.
#include "sculpt/removal_queue.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

constexpr std::size_t kRanks = 70;  // more than one word of bits, twice

/// Pushes and pops at random; counts pops that a sorted list would not have given.
template <class Queue>
std::size_t wrong_pops(const ManifoldSolid& solid, std::uint64_t seed) {
  const auto earlier = [&](const RemovalEntry& a, const RemovalEntry& b) {
    return a.key != b.key ? a.key < b.key
                          : corners_less(solid.vertices(a.tet), solid.vertices(b.tet));
  };
  point_sets::Random random(seed);
  Queue queue(solid, kRanks);
  std::vector<RemovalEntry> held;
  std::size_t wrong = 0;
  for (int i = 0; i < 4000; ++i) {
    if (!held.empty() && random.bits() % 5 < 2) {
      const auto least = std::min_element(held.begin(), held.end(), earlier);
      const RemovalEntry popped = queue.pop();
      wrong += popped.key != least->key || popped.tet != least->tet;
      held.erase(least);
    } else {
      const double rank = static_cast<double>(random.bits() % kRanks);
      const double behind = random.bits() % 3 == 0 ? kBehindAll : 0;
      const TetId tet{
          static_cast<std::uint32_t>(random.bits() % solid.complex().finite_tet_count())};
      held.push_back({behind - rank, tet});
      queue.push(held.back());
    }
    wrong += queue.empty() != held.empty();
  }
  queue.clear();
  return wrong + (queue.empty() ? 0 : 1);
}

TEST_CASE("pops come in order, whatever was pushed in between") {
  const auto stages = testing::stages(point_sets::uniform_cube(60, 1));
  const ManifoldSolid solid = stages.solid();
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    CAPTURE(seed);
    CHECK(wrong_pops<KeyQueue>(solid, seed) == 0);
    CHECK(wrong_pops<RankQueue>(solid, seed) == 0);
  }
}

TEST_CASE("a rank at either end of the range") {
  const auto stages = testing::stages(point_sets::uniform_cube(60, 1));
  const ManifoldSolid solid = stages.solid();
  for (const std::size_t ranks : {1u, 64u, 65u, 4096u, 300000u}) {
    RankQueue queue(solid, ranks);
    const double last = static_cast<double>(ranks - 1);
    for (const double key : {kBehindAll - last, kBehindAll, -last, 0.0})
      queue.push({key, TetId{0}});
    std::vector<double> popped;
    while (!queue.empty()) popped.push_back(queue.pop().key);
    CAPTURE(ranks);
    CHECK(popped == std::vector<double>{-last, 0, kBehindAll - last, kBehindAll});
  }
}

}  // namespace
}  // namespace tetsculpt
