// in_perturbed_equatorial_sphere agrees with the oracle, on all ties of small lattices and beyond.
#include <doctest/doctest.h>

#include <cstdint>

#include "kernel/perturbation.h"
#include "tests/support/exact_predicates.h"
#include "tests/support/near_degenerate.h"
#include "tests/support/random_cases.h"

namespace tetsculpt {
namespace {

using namespace near_degenerate;

constexpr std::uint64_t kSeed = 2112;
constexpr int kCases = testing::random_cases(1'000'000);

Sign as_sign(bool inside) { return inside ? Sign::kPositive : Sign::kNegative; }

/// Compares many cases, and counts which point decided ties.
struct Comparison {
  exact::Agreement agreement;
  /// Per rank, argument and answer.
  std::array<std::array<std::array<std::int64_t, 2>, 4>, 4> ties{};

  void add(const Points<4>& points) {
    const auto& [a, b, c, p] = points;
    if (p == a || p == b || p == c || exact::collinear(a, b, c)) return;
    const exact::PerturbedSide expected = exact::in_perturbed_equatorial_sphere(a, b, c, p);
    agreement.add(as_sign(expected.inside), as_sign(in_perturbed_equatorial_sphere(a, b, c, p)),
                  points);
    if (expected.rank < 0) return;
    ++ties[static_cast<std::size_t>(expected.rank)][expected.argument][expected.inside];
  }

  /// The greatest point, or the next one if p projects on the edge opposite to it. Never a third:
  /// with two zeros, p would project on a corner, and thus be it.
  void check_that_every_branch_occurred() const {
    for (std::size_t rank = 0; rank < 4; ++rank) {
      for (std::size_t argument = 0; argument < 4; ++argument) {
        const auto [outside, inside] = ties[rank][argument];
        const bool corner = argument < 3;
        CHECK((inside > 0) == (rank < 2 && corner));
        // With one coordinate zero, p projects on an edge, where the other two are positive.
        CHECK((outside > 0) == (rank == 0 || (rank == 1 && !corner)));
      }
    }
  }
};

TEST_CASE("all ordered quadruples of the lattice {0..2}^3") {
  const auto point = [](int i) { return Point3{double(i / 9), double(i / 3 % 3), double(i % 3)}; };
  Comparison comparison;
  for (int code = 0; code < 27 * 27 * 27 * 27; code += testing::kSanitized ? 7 : 1) {
    comparison.add(
        {point(code % 27), point(code / 27 % 27), point(code / 729 % 27), point(code / 19683)});
  }
  MESSAGE("all of {0..2}^3: ", comparison.agreement.summary());
  CHECK(comparison.agreement.failures() == 0);
  comparison.check_that_every_branch_occurred();
}

TEST_CASE("random quadruples of the lattice {0..3}^3") {
  Rng rng(kSeed);
  Comparison comparison;
  for (int i = 0; i < kCases; ++i) {
    Points<4> points;
    for (Point3& p : points) p = {double(rng() % 4), double(rng() % 4), double(rng() % 4)};
    comparison.add(points);
  }
  MESSAGE("seed ", kSeed, ": ", comparison.agreement.summary());
  CHECK(comparison.agreement.failures() == 0);
  comparison.check_that_every_branch_occurred();
}

TEST_CASE("rotated, moved and nudged spheres") {
  Rng rng(kSeed + 1);
  Comparison comparison;
  for (int i = 0; i < kCases; ++i) {
    comparison.add(hard_case<4>(rng, [](Rng& r) {
      const EqualVectors equal(r);
      return mapped<4>(r, {equal.on_circle(r), equal.on_circle(r), equal.on_circle(r),
                           r() % 8 == 0 ? equal.on_circle(r) : equal.on_sphere(r)});
    }));
  }
  MESSAGE("seed ", kSeed + 1, ": ", comparison.agreement.summary());
  CHECK(comparison.agreement.failures() == 0);
  comparison.check_that_every_branch_occurred();
}

}  // namespace
}  // namespace tetsculpt
