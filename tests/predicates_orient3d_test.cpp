// orient3d is exact: also for four points of a plane or line, an ulp off.
#include <doctest/doctest.h>

#include <cstdint>

#include "kernel/predicates.h"
#include "tests/support/exact_predicates.h"
#include "tests/support/near_degenerate.h"
#include "tests/support/random_cases.h"

namespace tetsculpt {
namespace {

using namespace near_degenerate;

constexpr std::uint64_t kSeed = 2102;
constexpr int kCases = testing::random_cases(1'000'000);

/// Four points of the plane z = x + y whose coordinates have very different magnitudes.
Points<4> ragged_plane(Rng& rng) {
  Points<4> points;
  for (Point3& p : points) {
    const int exponent = static_cast<int>(random_in(rng, -60, 60));
    const auto x = static_cast<double>(random_in(rng, -0xfffff, 0xfffff));
    const auto y = static_cast<double>(random_in(rng, -0xfffff, 0xfffff));
    p.x = std::ldexp(x, exponent);
    p.y = std::ldexp(y, exponent + static_cast<int>(random_in(rng, 0, 30)));
    p.z = p.x + p.y;
  }
  return points;
}

/// Four points of a plane; now and then of a line.
Points<4> coplanar(Rng& rng) {
  if (rng() % 4 == 0) return ragged_plane(rng);
  const std::int64_t reach = std::int64_t{1} << random_in(rng, 1, 14);
  const bool on_line = rng() % 16 == 0;
  Vectors<4> points;
  for (Vector& p : points) {
    p = {random_in(rng, -reach, reach), on_line ? 0 : random_in(rng, -reach, reach), 0};
  }
  return mapped<4>(rng, points);
}

TEST_CASE("orient3d agrees with the oracle") {
  Rng rng(kSeed);
  exact::Agreement agreement;
  for (int i = 0; i < kCases; ++i) {
    const Points<4> points = hard_case<4>(rng, coplanar);
    const auto& [a, b, c, d] = points;
    agreement.add(exact::orient3d(a, b, c, d), orient3d(a, b, c, d), points);
  }
  MESSAGE("seed ", kSeed, ": ", agreement.summary());
  CHECK(agreement.failures() == 0);
  CHECK(agreement.covers_all_signs(10));
}

}  // namespace
}  // namespace tetsculpt
