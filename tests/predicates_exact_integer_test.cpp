// The oracles' integers obey the laws of a ring and agree with built-in arithmetic where that is
// exact.
#include <doctest/doctest.h>

#include <cstdint>
#include <random>
#include <stdexcept>

#include "tests/support/exact_integer.h"

namespace tetsculpt::exact {
namespace {

constexpr std::uint64_t kSeed = 2101;

/// A signed integer of up to `bits` bits, every length equally likely.
std::int64_t random_bits(std::mt19937_64& rng, std::uint64_t bits) {
  const auto magnitude = static_cast<std::int64_t>(rng() >> (64 - 1 - rng() % bits));
  return rng() % 2 == 0 ? magnitude : -magnitude;
}

ExactInteger random_long(std::mt19937_64& rng) {
  const auto high = static_cast<double>(random_bits(rng, 53));
  const auto low = static_cast<double>(random_bits(rng, 53));
  const int shift = static_cast<int>(rng() % 300);
  return ExactInteger::from_double(high, -shift) + ExactInteger::from_double(low, 0);
}

TEST_CASE("agrees with 64-bit arithmetic") {
  MESSAGE("seed ", kSeed);
  std::mt19937_64 rng(kSeed);
  int wrong = 0;
  for (int i = 0; i < 200'000; ++i) {
    const std::int64_t a = random_bits(rng, 31), b = random_bits(rng, 31);
    const ExactInteger A(a), B(b);
    wrong += !(A + B == ExactInteger(a + b));
    wrong += !(A - B == ExactInteger(a - b));
    wrong += !(A * B == ExactInteger(a * b));
    wrong += (A - B).sign() != sign_of(static_cast<double>(a - b));
  }
  CHECK(wrong == 0);
}

TEST_CASE("obeys the laws of a ring") {
  std::mt19937_64 rng(kSeed + 1);
  const ExactInteger zero, one(1);
  int wrong = 0;
  for (int i = 0; i < 50'000; ++i) {
    const ExactInteger a = random_long(rng), b = random_long(rng), c = random_long(rng);
    wrong += !(a + b == b + a) || !((a + b) + c == a + (b + c));
    wrong += !(a * b == b * a) || !((a * b) * c == a * (b * c));
    wrong += !(a * (b + c) == a * b + a * c);
    wrong += !((a - b) + b == a) || !(a - a == zero) || !(a * one == a) || !(a * zero == zero);
    wrong += (a * b).sign() != static_cast<Sign>(int(a.sign()) * int(b.sign()));
    wrong += (a * a - b * b).sign() != static_cast<Sign>(int((a - b).sign()) * int((a + b).sign()));
  }
  CHECK(wrong == 0);
}

TEST_CASE("carries and borrows run through") {
  const ExactInteger one(1);
  const ExactInteger huge = ExactInteger::from_double(0x1p320, 0);
  CHECK((huge - one) + one == huge);
  CHECK((huge - one) * (huge + one) == huge * huge - one);
  CHECK(((huge - one) - huge) == ExactInteger(-1));
  CHECK(ExactInteger(INT64_MIN) + ExactInteger(INT64_MAX) == ExactInteger(-1));
  CHECK((one - huge).sign() == Sign::kNegative);
}

TEST_CASE("takes doubles without rounding") {
  CHECK(ExactInteger::from_double(-0.75, -2) == ExactInteger(-3));
  CHECK(ExactInteger::from_double(-0.0, 7) == ExactInteger());
  CHECK(ExactInteger::from_double(0x1.fffffffffffffp-1, -53) == ExactInteger((1LL << 53) - 1));
  CHECK(ExactInteger::from_double(0x1p-179, -179) == ExactInteger(1));
  CHECK(ExactInteger::from_double(0x1p168, 60) ==
        ExactInteger::from_double(0x1p54, 0) * ExactInteger::from_double(0x1p54, 0));
  CHECK_THROWS_AS(ExactInteger::from_double(0.5, 0), std::domain_error);
  CHECK_THROWS_AS(ExactInteger::from_double(0x1p1000, -1074) * ExactInteger::from_double(2, -500),
                  std::length_error);
}

}  // namespace
}  // namespace tetsculpt::exact
