// Threads that are not equally fast: one that is done takes some of what another has left.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <thread>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/lifted_hull.h"
#include "tests/support/point_sets.h"
#include "tests/support/random_cases.h"

namespace tetsculpt {
namespace {

using point_sets::NamedPoints;

/// In which a thread inserts its half of the points, and far more.
constexpr std::chrono::milliseconds kLong(testing::kSanitized ? 1000 : 150);

/// So many that a thread that waits has enough left to share.
std::vector<NamedPoints> large_sets() {
  return {{"cube, seed 1", point_sets::uniform_cube(50000, 1)},
          {"bumpy sphere, seed 2", point_sets::bumpy_sphere(50000, 2)},
          {"grid of side 36", point_sets::grid(36)},
          {"clusters, seed 3", point_sets::clusters(50000, 3)}};
}

/// In a thread's first share and those that follow when work is shared out again. The last round
/// is told from a twentieth to 0.85 of the work.
void sleep_in_last_round(double share) {
  if (share > 0.05 && share < 0.8) std::this_thread::sleep_for(kLong);
}

bool same(const LiftedHull& a, const LiftedHull& b) {
  return a.finite_count == b.finite_count && a.tets == b.tets && a.neighbors == b.neighbors;
}

TEST_CASE("the hull is the same while the caller's thread sleeps") {
  for (const NamedPoints& set : testing::some_of(large_sets())) {
    CAPTURE(set.name);
    const LargeArray<Point3> points = distinct_points(set.points).points;
    const LiftedHull expected = lifted_hull(points, {});
    REQUIRE(expected.finite_count > 0);
    for (const int threads : {2, 3}) {
      CAPTURE(threads);
      CHECK(same(lifted_hull(points, {.threads = threads, .progress = sleep_in_last_round}),
                 expected));
    }
  }
}

TEST_CASE("what a thread that sleeps has left is shared when another is done") {
  const LargeArray<Point3> points = distinct_points(point_sets::uniform_cube(50000, 4)).points;
  std::vector<double> shares;
  lifted_hull(points, {.threads = 2, .progress = [&](double share) {
                         shares.push_back(share);
                         sleep_in_last_round(share);
                       }});
  // Told within the last round is what was taken when its sites are shared out again: that only
  // half were, where both halves had not been, is told once.
  const auto half = [](double share) { return share > 0.3 && share < 0.5; };
  CHECK(std::ranges::count_if(shares, half) == 1);
}

TEST_CASE("what progress throws on one of several threads is what the caller gets") {
  const LargeArray<Point3> points = distinct_points(point_sets::bumpy_sphere(50000, 5)).points;
  struct Enough : std::runtime_error {
    using runtime_error::runtime_error;
  };
  for (const double last : {0.0, 0.05, 0.3, 0.7}) {
    CAPTURE(last);
    const auto progress = [&](double done) {
      if (done > last) throw Enough("enough");
    };
    CHECK_THROWS_AS(lifted_hull(points, {.threads = 3, .progress = progress}), Enough);
  }
}

}  // namespace
}  // namespace tetsculpt
