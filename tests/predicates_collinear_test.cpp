// collinear is exact: also for three points of a line, an ulp off.
#include <doctest/doctest.h>

#include <cstdint>

#include "kernel/predicates.h"
#include "tests/support/exact_predicates.h"
#include "tests/support/near_degenerate.h"
#include "tests/support/random_cases.h"

namespace tetsculpt {
namespace {

using namespace near_degenerate;

constexpr std::uint64_t kSeed = 2108;
constexpr int kCases = testing::random_cases(1'000'000);

/// Three points of the line through zero and (1, 3, -5), at very different distances.
Points<3> ragged_line(Rng& rng) {
  Points<3> points;
  for (Point3& p : points) {
    const auto mantissa = static_cast<double>(rng() >> 14);  // 50 bits, so that 5 t is exact
    const double t = std::ldexp(mantissa, static_cast<int>(random_in(rng, -100, 40)));
    p = {t, 3 * t, -5 * t};
  }
  return points;
}

/// Three points of a line along an axis or across; equal ones among them.
Points<3> on_line(Rng& rng) {
  if (rng() % 4 == 0) return ragged_line(rng);
  const std::int64_t reach = std::int64_t{1} << random_in(rng, 1, 6);
  const Vector direction = rng() % 4 == 0 ? Vector{1, 0, 0} : random_vector(rng, 256);
  Vectors<3> points;
  for (Vector& p : points) {
    const std::int64_t t = random_in(rng, -reach, reach);
    p = {t * direction[0], t * direction[1], t * direction[2]};
  }
  return mapped<3>(rng, points);
}

/// Zero stands for collinear.
Sign as_sign(bool collinear) { return collinear ? Sign::kZero : Sign::kPositive; }

TEST_CASE("collinear agrees with the oracle") {
  Rng rng(kSeed);
  exact::Agreement agreement;
  for (int i = 0; i < kCases; ++i) {
    const Points<3> points = hard_case<3>(rng, on_line);
    const auto& [a, b, c] = points;
    agreement.add(as_sign(exact::collinear(a, b, c)), as_sign(collinear(a, b, c)), points);
  }
  MESSAGE("seed ", kSeed, ": ", agreement.summary());
  CHECK(agreement.failures() == 0);
  CHECK(agreement.occurrences(Sign::kZero) > kCases / 10);
  CHECK(agreement.occurrences(Sign::kPositive) > kCases / 10);
}

}  // namespace
}  // namespace tetsculpt
