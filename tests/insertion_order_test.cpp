// The rounds of insertion hold each vertex once; they grow, and each is spaced evenly.
#include "kernel/insertion_order.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace tetsculpt {
namespace {

std::vector<std::size_t> vertices_of(const InsertionRound& round, std::size_t begin,
                                     std::size_t end) {
  std::vector<std::size_t> vertices;
  round.each(begin, end, [&](std::size_t v) { vertices.push_back(v); });
  return vertices;
}

TEST_CASE("each vertex is in one round, in ascending order") {
  for (const std::size_t n : {0u, 1u, 2u, 4u, 63u, 64u, 65u, 512u, 513u, 1000u, 20000u}) {
    CAPTURE(n);
    std::vector<int> times(n, 0);
    for (const InsertionRound& round : insertion_rounds(n)) {
      const std::vector<std::size_t> vertices = vertices_of(round, 0, n);
      CHECK(vertices.size() == round.size());
      CHECK(std::ranges::adjacent_find(vertices, std::ranges::greater_equal{}) == vertices.end());
      for (const std::size_t v : vertices) ++times[v];
    }
    CHECK(std::ranges::count(times, 1) == static_cast<std::ptrdiff_t>(n));
  }
}

TEST_CASE("parts of a round") {
  for (const InsertionRound& round : insertion_rounds(5000)) {
    std::vector<std::size_t> joined;
    for (const auto& [begin, end] : {std::pair{0u, 1u}, {1u, 64u}, {64u, 1001u}, {1001u, 5000u}}) {
      const std::vector<std::size_t> part = vertices_of(round, begin, end);
      joined.insert(joined.end(), part.begin(), part.end());
    }
    CHECK(joined == vertices_of(round, 0, 5000));
  }
}

TEST_CASE("a round is about fifteen times as large as all before it, and spaced evenly") {
  const std::vector<InsertionRound> rounds = insertion_rounds(100000);
  CHECK(rounds.size() > 3);
  CHECK(rounds[0].size() <= 64);
  std::size_t before = rounds[0].size();
  for (std::size_t r = 1; r < rounds.size(); ++r) {
    CAPTURE(r);
    const std::size_t size = rounds[r].size();
    CHECK(size > 14 * before);
    CHECK(size < 16 * before);
    before += size;
    const std::vector<std::size_t> vertices = vertices_of(rounds[r], 0, 100000);
    std::size_t nearest = 100000, farthest = 0;
    for (std::size_t k = 1; k < vertices.size(); ++k) {
      nearest = std::min(nearest, vertices[k] - vertices[k - 1]);
      farthest = std::max(farthest, vertices[k] - vertices[k - 1]);
    }
    CHECK(nearest > 0);
    CHECK(farthest == 2 * nearest);
  }
}

}  // namespace
}  // namespace tetsculpt
