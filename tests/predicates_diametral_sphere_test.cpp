// in_diametral_sphere is exact: also for a right angle over ab, an ulp off.
#include <doctest/doctest.h>

#include <cstdint>

#include "kernel/predicates.h"
#include "tests/support/exact_predicates.h"
#include "tests/support/near_degenerate.h"
#include "tests/support/random_cases.h"

namespace tetsculpt {
namespace {

using namespace near_degenerate;

constexpr std::uint64_t kSeed = 2104;
constexpr int kCases = testing::random_cases(1'000'000);

/// p sees ab under a right angle: two opposite points of a sphere and a third one; or p on the line
/// ab.
Points<3> right_angled(Rng& rng) {
  if (rng() % 4 == 0) {
    Points<3> points = ragged_sphere<3>(rng, false);
    points[1] = {-points[0].x, -points[0].y, -points[0].z};
    return points;
  }
  const EqualVectors equal(rng);
  const Vector a = equal.on_sphere(rng);
  const Vector b = {-a[0], -a[1], -a[2]};
  return mapped<3>(rng, {a, b, rng() % 16 == 0 ? b : equal.on_sphere(rng)});
}

TEST_CASE("in_diametral_sphere agrees with the oracle") {
  Rng rng(kSeed);
  exact::Agreement agreement;
  for (int i = 0; i < kCases; ++i) {
    const Points<3> points = hard_case<3>(rng, right_angled);
    const auto& [a, b, p] = points;
    agreement.add(exact::in_diametral_sphere(a, b, p), in_diametral_sphere(a, b, p), points);
  }
  MESSAGE("seed ", kSeed, ": ", agreement.summary());
  CHECK(agreement.failures() == 0);
  CHECK(agreement.covers_all_signs(10));
}

}  // namespace
}  // namespace tetsculpt
