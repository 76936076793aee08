// insphere is exact: also for five points of a sphere, a plane or a circle, an ulp off.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <optional>

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

/// Points of the lattice of this unit about a far point of it, less than 2 `spread` units apart: of
/// a sphere, or with one of them a unit off.
Points<5> on_lattice(Rng& rng, double unit, std::int64_t spread) {
  const EqualVectors equal(rng);
  const Vector corner = random_vector(rng, 1 << 20);
  const std::int64_t scale = 1 + static_cast<std::int64_t>(rng() % 64);
  const bool off = rng() % 4 != 0;
  Points<5> points;
  for (Point3& p : points) {
    Vector v = equal.on_sphere(rng);
    for (std::int64_t& x : v) x = x * scale % spread;
    if (off && &p == &points[4]) ++v[rng() % 3];
    const auto coordinate = [&](std::size_t i) {
      return static_cast<double>(corner[i] + v[i]) * unit;
    };
    p = {coordinate(0), coordinate(1), coordinate(2)};
  }
  return points;
}

TEST_CASE("insphere_in_units agrees with the oracle on lattices") {
  Rng rng(kSeed + 2);
  for (const double unit : {1.0, 0x1p-30, 0x1p-300, 0x1p300}) {
    exact::Agreement agreement;
    for (int i = 0; i < kCases / 4; ++i) {
      const Points<5> points = on_lattice(rng, unit, 1 << 21);
      const auto& [a, b, c, d, e] = points;
      const auto side = insphere_in_units(a, b, c, d, e, 1 / unit);
      REQUIRE(side);
      agreement.add(exact::insphere(a, b, c, d, e), *side, points);
    }
    MESSAGE("seed ", kSeed + 2, ", unit ", unit, ": ", agreement.summary());
    CHECK(agreement.failures() == 0);
    CHECK(agreement.covers_all_signs(10));
  }
}

TEST_CASE("insphere_in_units leaves alone what is too far apart, or no unit at all") {
  const Point3 o{0, 0, 0};
  const Point3 x{1, 0, 0};
  const Point3 y{0, 1, 0};
  const Point3 z{0, 0, 1};
  CHECK(insphere_in_units(o, y, x, z, {0x1p23, 0, 0}, 1) == std::nullopt);
  CHECK(insphere_in_units(o, y, x, z, {0x1p22, 0, 0}, 1) == insphere(o, y, x, z, {0x1p22, 0, 0}));
  CHECK(insphere_in_units(o, y, x, z, {0.5, 0.5, 0.5}, HUGE_VAL) == std::nullopt);
}

}  // namespace
}  // namespace tetsculpt
