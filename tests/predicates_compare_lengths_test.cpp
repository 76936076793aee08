// compare_lengths is exact: also for edges of equal length, an ulp off.
#include <doctest/doctest.h>

#include <cstdint>

#include "kernel/predicates.h"
#include "tests/support/exact_predicates.h"
#include "tests/support/near_degenerate.h"
#include "tests/support/random_cases.h"

namespace tetsculpt {
namespace {

using namespace near_degenerate;

constexpr std::uint64_t kSeed = 2107;
constexpr int kCases = testing::random_cases(1'000'000);

/// Two edges of equal length, anywhere; or one and its image with the axes exchanged.
Points<4> equally_long(Rng& rng) {
  if (rng() % 4 == 0) {
    const Point3 a{ragged(rng), ragged(rng), ragged(rng)}, b{ragged(rng), ragged(rng), ragged(rng)};
    return {a, b, Point3{-b.y, b.z, -b.x}, Point3{-a.y, a.z, -a.x}};
  }
  const EqualVectors equal(rng);
  const Vector a = random_vector(rng, 1000), c = random_vector(rng, 1000);
  const Vector u = equal.on_sphere(rng), v = equal.on_sphere(rng);
  return mapped<4>(rng, {a, Vector{a[0] + u[0], a[1] + u[1], a[2] + u[2]}, c,
                         Vector{c[0] + v[0], c[1] + v[1], c[2] + v[2]}});
}

TEST_CASE("compare_lengths agrees with the oracle") {
  Rng rng(kSeed);
  exact::Agreement agreement;
  for (int i = 0; i < kCases; ++i) {
    const Points<4> points = hard_case<4>(rng, equally_long);
    const auto& [a, b, c, d] = points;
    agreement.add(exact::compare_lengths(a, b, c, d), compare_lengths(a, b, c, d), points);
  }
  MESSAGE("seed ", kSeed, ": ", agreement.summary());
  CHECK(agreement.failures() == 0);
  CHECK(agreement.covers_all_signs(10));
}

}  // namespace
}  // namespace tetsculpt
