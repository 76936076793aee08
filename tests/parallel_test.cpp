// Loops on several threads do each item once, whoever does it, and tell the first error.
#include "kernel/parallel.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace tetsculpt {
namespace {

TEST_CASE("cuts cover all, in order") {
  for (const std::size_t n : {0u, 1u, 4095u, 8192u, 100000u, 1000000u}) {
    for (const int threads : {-1, 0, 1, 2, 7}) {
      CAPTURE(n);
      CAPTURE(threads);
      for (const auto& cuts : {range_cuts(n, threads), share_cuts(n, threads)}) {
        CHECK(cuts.size() >= 2);
        CHECK(cuts.front() == 0);
        CHECK(cuts.back() == n);
        CHECK(std::ranges::is_sorted(cuts));
      }
    }
  }
  CHECK(share_cuts(1000000, 1).size() == 2);
  CHECK(share_cuts(1000000, 2).size() > range_cuts(1000000, 2).size());
}

TEST_CASE("each share is done once") {
  for (const std::size_t count : {0u, 1u, 2u, 5u, 16u, 1000u}) {
    for (const int threads : {0, 1, 2, 3, 8}) {
      CAPTURE(count);
      CAPTURE(threads);
      std::vector<std::atomic<int>> times(count);
      parallel_shares(count, threads, [&](std::size_t i) { ++times[i]; });
      for (const auto& t : times) CHECK(t == 1);
    }
  }
}

TEST_CASE("what a thread that waits has left is done by another") {
  std::atomic<int> left = 15;
  // The first share ends only when all others are done, those of its own thread, too.
  parallel_shares(16, 2, [&](std::size_t i) {
    if (i != 0) {
      --left;
      left.notify_all();
    }
    for (int now = left; i == 0 && now != 0; now = left) left.wait(now);
  });
  CHECK(left == 0);
}

TEST_CASE("results come in the order of ranges") {
  const auto cuts = share_cuts(100000, 3);
  const auto begins =
      parallel_results(cuts, 3, [](std::size_t begin, std::size_t) { return begin; });
  CHECK(begins == std::vector<std::size_t>(cuts.begin(), cuts.end() - 1));
  std::atomic<std::size_t> sum = 0;
  parallel_ranges(100000, 3, [&](std::size_t begin, std::size_t end) { sum += end - begin; });
  CHECK(sum == 100000);
}

TEST_CASE("the error of the lowest share is told") {
  for (const int threads : {1, 2, 5}) {
    CAPTURE(threads);
    const auto fail = [](std::size_t i) {
      if (i % 7 == 3) throw std::runtime_error(std::to_string(i));
    };
    CHECK_THROWS_WITH(parallel_shares(50, threads, fail), "3");
    const auto fail_late = [](std::size_t i) {
      if (i >= 40) throw std::runtime_error(std::to_string(i));
    };
    CHECK_THROWS_WITH(parallel_shares(50, threads, fail_late), "40");
  }
}

}  // namespace
}  // namespace tetsculpt
