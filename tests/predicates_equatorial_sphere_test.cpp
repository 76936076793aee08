// in_equatorial_sphere is exact: also for p on the sphere and for flat triangles, an ulp off.
#include <doctest/doctest.h>

#include <cstdint>

#include "kernel/predicates.h"
#include "tests/support/exact_predicates.h"
#include "tests/support/near_degenerate.h"
#include "tests/support/random_cases.h"

namespace tetsculpt {
namespace {

using namespace near_degenerate;

constexpr std::uint64_t kSeed = 2105;
constexpr int kCases = testing::random_cases(1'000'000);

/// p on the sphere about a circle through a, b, c; now and then all four on a line or on the
/// circle.
Points<4> on_equatorial_sphere(Rng& rng) {
  if (rng() % 4 == 0) {
    Points<4> points = ragged_sphere<4>(rng, true);
    Point3& p = points[3];
    const auto [x, y, z] = signed_permutation<double, 3>(rng, {p.x, p.y, p.z});
    p = {x, y, z};
    return points;
  }
  const EqualVectors equal(rng);
  const std::uint64_t kind = rng() % 16;
  if (kind == 0) {
    const auto at = [&rng] { return Vector{random_in(rng, -1000, 1000), 0, 0}; };
    return mapped<4>(rng, {at(), at(), at(), at()});
  }
  return mapped<4>(rng, {equal.on_circle(rng), equal.on_circle(rng), equal.on_circle(rng),
                         kind == 1 ? equal.on_circle(rng) : equal.on_sphere(rng)});
}

TEST_CASE("in_equatorial_sphere agrees with the oracle") {
  Rng rng(kSeed);
  exact::Agreement agreement;
  for (int i = 0; i < kCases; ++i) {
    const Points<4> points = hard_case<4>(rng, on_equatorial_sphere);
    const auto& [a, b, c, p] = points;
    agreement.add(exact::in_equatorial_sphere(a, b, c, p), in_equatorial_sphere(a, b, c, p),
                  points);
  }
  MESSAGE("seed ", kSeed, ": ", agreement.summary());
  CHECK(agreement.failures() == 0);
  CHECK(agreement.covers_all_signs(10));
}

}  // namespace
}  // namespace tetsculpt
