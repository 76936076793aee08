// The perturbed spheres have one opinion: whichever of the points is taken as the one tested, and
// in whichever order the others are named.
#include <doctest/doctest.h>

#include <cstdint>

#include "kernel/perturbation.h"
#include "kernel/predicates.h"
#include "tests/support/near_degenerate.h"
#include "tests/support/random_cases.h"

namespace tetsculpt {
namespace {

using namespace near_degenerate;

constexpr std::uint64_t kSeed = 2113;
constexpr int kCases = testing::random_cases(100'000);

Points<5> cospherical(Rng& rng) {
  if (rng() % 4 == 0) return ragged_sphere<5>(rng, false);
  const EqualVectors equal(rng);
  Vectors<5> points;
  for (Vector& p : points) p = rng() % 3 == 0 ? equal.on_circle(rng) : equal.on_sphere(rng);
  return mapped<5>(rng, points);
}

bool distinct(const Points<5>& points) {
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (points[i] == points[j]) return false;
    }
  }
  return true;
}

TEST_CASE("d and e exchanged: on the same side of abc, one sphere holds the other's apex") {
  Rng rng(kSeed);
  int broken = 0, same_side = 0, other_side = 0;
  for (int i = 0; i < kCases; ++i) {
    Points<5> points = hard_case<5>(rng, cospherical);
    auto& [a, b, c, d, e] = points;
    if (!distinct(points) || orient3d(a, b, c, d) == Sign::kZero) continue;
    if (orient3d(a, b, c, d) == Sign::kNegative) std::swap(a, b);
    const bool holds_e = in_perturbed_sphere(a, b, c, d, e);
    const Sign side = orient3d(a, b, c, e);
    if (side == Sign::kPositive) broken += in_perturbed_sphere(a, b, c, e, d) == holds_e;
    if (side == Sign::kNegative) broken += in_perturbed_sphere(b, a, c, e, d) != holds_e;
    same_side += side == Sign::kPositive;
    other_side += side == Sign::kNegative;
  }
  MESSAGE("seed ", kSeed, ": same side ", same_side, ", other side ", other_side);
  CHECK(broken == 0);
  CHECK(same_side > kCases / 10);
  CHECK(other_side > kCases / 10);
}

TEST_CASE("the order in which the corners are named is irrelevant") {
  Rng rng(kSeed + 1);
  int broken = 0, ties = 0;
  for (int i = 0; i < kCases; ++i) {
    Points<5> points = hard_case<5>(rng, cospherical);
    auto& [a, b, c, d, e] = points;
    if (!distinct(points) || orient3d(a, b, c, d) == Sign::kZero) continue;
    if (orient3d(a, b, c, d) == Sign::kNegative) std::swap(a, b);
    const bool inside = in_perturbed_sphere(a, b, c, d, e);
    broken += in_perturbed_sphere(b, c, a, d, e) != inside;
    broken += in_perturbed_sphere(b, a, d, c, e) != inside;
    broken += in_perturbed_sphere(a, d, b, c, e) != inside;
    const Sign sign = insphere(a, b, c, d, e);
    ties += sign == Sign::kZero;
    if (sign != Sign::kZero) broken += inside != (sign == Sign::kPositive);
  }
  MESSAGE("seed ", kSeed + 1, ": ties ", ties);
  CHECK(broken == 0);
  CHECK(ties > kCases / 10);
}

TEST_CASE("edges and triangles, too, have no first corner") {
  Rng rng(kSeed + 2);
  int broken = 0, ties = 0;
  for (int i = 0; i < kCases; ++i) {
    const Points<5> points = hard_case<5>(rng, cospherical);
    const auto& [a, b, c, p, unused] = points;
    if (!distinct(points)) continue;
    const bool in_edge = in_perturbed_diametral_sphere(a, b, p);
    broken += in_perturbed_diametral_sphere(b, a, p) != in_edge;
    if (collinear(a, b, c)) continue;
    const bool inside = in_perturbed_equatorial_sphere(a, b, c, p);
    broken += in_perturbed_equatorial_sphere(b, c, a, p) != inside;
    broken += in_perturbed_equatorial_sphere(c, b, a, p) != inside;
    ties += in_equatorial_sphere(a, b, c, p) == Sign::kZero;
  }
  MESSAGE("seed ", kSeed + 2, ": ties ", ties);
  CHECK(broken == 0);
  CHECK(ties > kCases / 100);
}

}  // namespace
}  // namespace tetsculpt
