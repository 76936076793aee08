// insphere is exact: also for five points of a sphere, a plane or a circle, an ulp off.
#include <doctest/doctest.h>

#include <cstdint>

#include "kernel/predicates.h"
#include "tests/support/exact_predicates.h"
#include "tests/support/near_degenerate.h"
#include "tests/support/random_cases.h"

namespace tetsculpt {
namespace {

using namespace near_degenerate;

constexpr std::uint64_t kSeed = 2103;
constexpr int kCases = testing::random_cases(1'000'000);

/// Five points of a sphere; now and then of a plane, or of a circle.
Points<5> cospherical(Rng& rng) {
  if (rng() % 4 == 0) return ragged_sphere<5>(rng, rng() % 8 == 0);
  const EqualVectors equal(rng);
  const std::uint64_t kind = rng() % 16;
  Vectors<5> points;
  for (Vector& p : points) {
    p = kind == 0   ? random_vector(rng, 1000)
        : kind == 1 ? equal.on_circle(rng)
                    : equal.on_sphere(rng);
    if (kind == 0) p[2] = 0;
  }
  return mapped<5>(rng, points);
}

TEST_CASE("insphere agrees with the oracle") {
  Rng rng(kSeed);
  exact::Agreement agreement;
  for (int i = 0; i < kCases; ++i) {
    const Points<5> points = hard_case<5>(rng, cospherical);
    const auto& [a, b, c, d, e] = points;
    agreement.add(exact::insphere(a, b, c, d, e), insphere(a, b, c, d, e), points);
  }
  MESSAGE("seed ", kSeed, ": ", agreement.summary());
  CHECK(agreement.failures() == 0);
  CHECK(agreement.covers_all_signs(10));
}

TEST_CASE("insphere agrees with the oracle on full mantissas alone") {
  Rng rng(kSeed + 1);
  exact::Agreement agreement;
  for (int i = 0; i < kCases; ++i) {
    const Points<5> points = random_points<5>(rng, full_mantissa);
    const auto& [a, b, c, d, e] = points;
    agreement.add(exact::insphere(a, b, c, d, e), insphere(a, b, c, d, e), points);
  }
  MESSAGE("seed ", kSeed + 1, ": ", agreement.summary());
  CHECK(agreement.failures() == 0);
}

}  // namespace
}  // namespace tetsculpt
