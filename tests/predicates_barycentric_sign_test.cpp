// barycentric_sign is exact: also for p above the line bc, an ulp off.
#include <doctest/doctest.h>

#include <cstdint>

#include "kernel/predicates.h"
#include "tests/support/exact_predicates.h"
#include "tests/support/near_degenerate.h"
#include "tests/support/random_cases.h"

namespace tetsculpt {
namespace {

using namespace near_degenerate;

constexpr std::uint64_t kSeed = 2106;
constexpr int kCases = testing::random_cases(1'000'000);

/// p projects on the line bc: a is in the plane z = 0, b and c on its diagonal, p above it.
Points<4> above_edge(Rng& rng) {
  if (rng() % 4 == 0) {
    const double b = ragged(rng), c = ragged(rng), p = ragged(rng);
    return {Point3{ragged(rng), ragged(rng), 0}, Point3{b, b, 0}, Point3{c, c, 0},
            Point3{p, p, ragged(rng)}};
  }
  const std::int64_t reach = std::int64_t{1} << random_in(rng, 1, 14);
  const auto any = [&rng, reach] { return random_in(rng, -reach, reach); };
  const std::int64_t b = any(), c = any(), p = any();
  return mapped<4>(rng, {Vector{any(), any(), 0}, Vector{b, b, 0}, Vector{c, c, 0},
                         Vector{p, p, rng() % 4 == 0 ? 0 : any()}});
}

TEST_CASE("barycentric_sign agrees with the oracle") {
  Rng rng(kSeed);
  exact::Agreement agreement;
  for (int i = 0; i < kCases; ++i) {
    const Points<4> points = hard_case<4>(rng, above_edge);
    const auto& [a, b, c, p] = points;
    agreement.add(exact::barycentric_sign(a, b, c, p), barycentric_sign(a, b, c, p), points);
  }
  MESSAGE("seed ", kSeed, ": ", agreement.summary());
  CHECK(agreement.failures() == 0);
  CHECK(agreement.covers_all_signs(10));
}

}  // namespace
}  // namespace tetsculpt
