// The order of insertion is a permutation in growing rounds, each by id.
#include "kernel/insertion_order.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tetsculpt {
namespace {

TEST_CASE("a permutation, cut into rounds of ascending ids") {
  for (const std::size_t n : {1u, 2u, 4u, 63u, 64u, 65u, 1000u, 20000u}) {
    CAPTURE(n);
    const InsertionOrder order = insertion_order(n);
    REQUIRE(order.round_begin.size() >= 2);
    CHECK(order.round_begin.front() == 0);
    CHECK(order.round_begin.back() == n);
    for (std::size_t r = 0; r + 1 < order.round_begin.size(); ++r) {
      REQUIRE(order.round_begin[r] <= order.round_begin[r + 1]);
      const auto at = [&](std::size_t round) {
        return order.vertices.begin() + static_cast<std::ptrdiff_t>(order.round_begin[round]);
      };
      CHECK(std::is_sorted(at(r), at(r + 1)));
    }
    auto vertices = order.vertices;
    std::ranges::sort(vertices);
    std::size_t wrong = vertices.size() != n;
    for (std::size_t i = 0; i < vertices.size(); ++i) wrong += +vertices[i] != i;
    CHECK(wrong == 0);
  }
  CHECK(insertion_order(0).vertices.empty());
}

TEST_CASE("a round is about seven times as large as all before it") {
  const InsertionOrder order = insertion_order(100000);
  CHECK(order.round_begin.size() > 4);
  for (std::size_t r = 2; r + 1 < order.round_begin.size(); ++r) {
    CAPTURE(r);
    const auto before = static_cast<double>(order.round_begin[r]);
    const double size = static_cast<double>(order.round_begin[r + 1]) - before;
    CHECK(size > 4 * before);
    CHECK(size < 14 * before);
  }
}

TEST_CASE("the vertices of a round are spaced evenly") {
  const InsertionOrder order = insertion_order(5000);
  for (std::size_t r = 0; r + 1 < order.round_begin.size(); ++r) {
    const auto at = [&](std::size_t k) { return +order.vertices[k]; };
    std::size_t nearest = 5000, farthest = 0;
    for (std::size_t k = order.round_begin[r] + 1; k < order.round_begin[r + 1]; ++k) {
      nearest = std::min(nearest, at(k) - at(k - 1));
      farthest = std::max(farthest, at(k) - at(k - 1));
    }
    CAPTURE(r);
    CHECK(nearest > 0);
    CHECK(farthest <= 2 * nearest);
  }
}

}  // namespace
}  // namespace tetsculpt
