// Sums, differences and products of numbers of twice a double's digits are off by no more than they
// promise, and stay such numbers; the error is taken in expansions, without error.
#include "kernel/double_double.h"

#include <doctest/doctest.h>

#include <cmath>

#include "kernel/expansion.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

using point_sets::Random;

double random_double(Random& random) {
  return std::ldexp(random.uniform(-1, 1), static_cast<int>(random.below(60)) - 30);
}

/// All digits used, few of them, or a double.
DoubleDouble random_number(Random& random) {
  const double high = random_double(random);
  const double half_ulp = std::ldexp(std::fabs(high), -54);
  const double low = random.below(3) == 0 ? 0 : random.uniform(-1, 1) * half_ulp;
  return {{high, random.below(3) == 0 ? std::ldexp(low, -20) : low}};
}

/// The same magnitude with the other sign, up to the last digits.
DoubleDouble nearly_opposite(Random& random, const DoubleDouble& a) {
  return {{-a.high, random.below(2) == 0 ? -a.low : -a.low + std::ldexp(a.low, -40)}};
}

Expansion exact(const DoubleDouble& a, ExpansionArena& arena) {
  return Expansion::number(a.high, arena) + Expansion::number(a.low, arena);
}

TEST_CASE("errors against expansions") {
  Random random(5);
  int wrong = 0, wide = 0, cancelled = 0;
  const auto check = [&](const DoubleDouble& result, const Expansion& expected,
                         ExpansionArena& arena) {
    const double error = std::fabs((exact(result, arena) - expected).estimate());
    wrong += error > DoubleDouble::kRounding * std::fabs(expected.estimate());
    wide += result.high + result.low != result.high;
  };
  for (int round = 0; round < 100'000; ++round) {
    ExpansionArena arena;
    const DoubleDouble a = random_number(random);
    const DoubleDouble b =
        random.below(2) == 0 ? random_number(random) : nearly_opposite(random, a);
    const Expansion x = exact(a, arena);
    const Expansion y = exact(b, arena);
    check(a + b, x + y, arena);
    check(a - b, x - y, arena);
    check(a * b, x * y, arena);
    check(DoubleDouble::difference(a.high, b.high),
          Expansion::number(a.high, arena) - Expansion::number(b.high, arena), arena);
    cancelled += std::fabs((a + b).high) < 1e-15 * std::fabs(a.high);
  }
  CHECK(wrong == 0);
  CHECK(wide == 0);
  CHECK(cancelled > 10'000);
}

}  // namespace
}  // namespace tetsculpt
