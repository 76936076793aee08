// in_perturbed_diametral_sphere agrees with the oracle, on all right angles of a lattice and
// beyond.
#include <doctest/doctest.h>

#include <cstdint>

#include "kernel/perturbation.h"
#include "tests/support/exact_predicates.h"
#include "tests/support/near_degenerate.h"
#include "tests/support/random_cases.h"

namespace tetsculpt {
namespace {

using namespace near_degenerate;

constexpr std::uint64_t kSeed = 2111;
constexpr int kCases = testing::random_cases(1'000'000);

Sign as_sign(bool inside) { return inside ? Sign::kPositive : Sign::kNegative; }

/// Compares many cases, and counts which argument decided ties.
struct Comparison {
  exact::Agreement agreement;
  std::array<std::int64_t, 3> ties{};
  std::int64_t ties_below_greatest = 0;

  void add(const Points<3>& points) {
    const auto& [a, b, p] = points;
    if (a == b || a == p || b == p) return;
    const exact::PerturbedSide expected = exact::in_perturbed_diametral_sphere(a, b, p);
    agreement.add(as_sign(expected.inside), as_sign(in_perturbed_diametral_sphere(a, b, p)),
                  points);
    if (expected.rank < 0) return;
    ++ties[expected.argument];
    ties_below_greatest += expected.rank > 0 || expected.inside != (expected.argument < 2);
  }

  void check_that_every_branch_occurred() const {
    for (const std::int64_t count : ties) CHECK(count > 1000);
    CHECK(ties_below_greatest == 0);
  }
};

TEST_CASE("all triples of the lattice {0..4}^3") {
  const auto point = [](int i) { return Point3{double(i / 25), double(i / 5 % 5), double(i % 5)}; };
  Comparison comparison;
  for (int a = 0; a < 125; a += testing::kSanitized ? 4 : 1) {
    for (int b = 0; b < 125; ++b) {
      for (int p = 0; p < 125; ++p) comparison.add({point(a), point(b), point(p)});
    }
  }
  MESSAGE("all of {0..4}^3: ", comparison.agreement.summary());
  CHECK(comparison.agreement.failures() == 0);
  comparison.check_that_every_branch_occurred();
}

TEST_CASE("rotated, moved and nudged right angles") {
  Rng rng(kSeed);
  Comparison comparison;
  for (int i = 0; i < kCases; ++i) {
    comparison.add(hard_case<3>(rng, [](Rng& r) {
      const EqualVectors equal(r);
      const Vector a = equal.on_sphere(r);
      return mapped<3>(r, {a, Vector{-a[0], -a[1], -a[2]}, equal.on_sphere(r)});
    }));
  }
  MESSAGE("seed ", kSeed, ": ", comparison.agreement.summary());
  CHECK(comparison.agreement.failures() == 0);
  comparison.check_that_every_branch_occurred();
}

}  // namespace
}  // namespace tetsculpt
