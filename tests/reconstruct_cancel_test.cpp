// A progress callback that throws cancels the work, at whatever call and on any number of threads.
#include <doctest/doctest.h>

#include <cstddef>
#include <vector>

#include "sculpt/reconstruct.h"
#include "tests/support/point_sets.h"
#include "tests/support/random_cases.h"

namespace tetsculpt {
namespace {

struct Cancelled {
  std::size_t call;
};

/// Runs until the given call of the callback. Returns the number of calls.
std::size_t calls_until(const std::vector<Point3>& points, std::size_t last,
                        ReconstructOptions options) {
  std::size_t calls = 0;
  options.progress = [&](std::string_view, double) {
    if (++calls > last) throw Cancelled{calls};
  };
  reconstruct(points, options);
  return calls;
}

void check_cancelling(std::size_t n, const ReconstructOptions& options) {
  const std::vector<Point3> points = point_sets::bumpy_sphere(n, 1);
  const std::size_t calls = calls_until(points, SIZE_MAX, options);
  constexpr std::size_t kLeast = 8;
  CHECK(calls > kLeast);
  const std::size_t step = testing::kSanitized ? 3 : 1;
  for (std::size_t last = 0; last < calls; last += step) {
    try {
      const std::size_t all = calls_until(points, last, options);
      // In how many passes threads share the points depends on how fast they are.
      INFO("not cancelled at call ", last);
      CHECK(options.threads > 1);
      CHECK(all > kLeast);
      CHECK(all <= last);
    } catch (const Cancelled& cancelled) {
      CHECK(cancelled.call == last + 1);
    }
  }
}

TEST_CASE("at each call") {
  check_cancelling(2000, {.method = Method::kGuided});
  check_cancelling(2000, {.method = Method::kPaper});
}

// Smaller sets are one thread's.
TEST_CASE("at each call, while another thread works") { check_cancelling(20000, {.threads = 2}); }

}  // namespace
}  // namespace tetsculpt
