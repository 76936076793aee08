// Laws of growth fitted to costs that follow them exactly, nearly, or not at all.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "bench/fit.h"

namespace tetsculpt::bench {
namespace {

template <class Cost>
std::vector<Sample> samples_of(Cost&& cost) {
  std::vector<Sample> samples;
  for (double size = 256; size <= 65'536; size *= 2) samples.push_back({size, cost(size)});
  return samples;
}

TEST_CASE("a power law is found again") {
  for (const double exponent : {-0.5, 0.0, 1.0, 1.37, 2.0}) {
    const auto samples = samples_of([&](double n) { return 3e-7 * std::pow(n, exponent); });
    const PowerLaw law = fit_power(samples);
    CHECK(law.factor == doctest::Approx(3e-7));
    CHECK(law.exponent == doctest::Approx(exponent));
    CHECK(law.relative_error == doctest::Approx(0));
  }
}

TEST_CASE("n log n is found again, and as a power law has an exponent just above 1") {
  const auto samples = samples_of([](double n) { return 5e-8 * n * std::log2(n); });
  const LogLinearLaw law = fit_log_linear(samples);
  CHECK(law.factor == doctest::Approx(5e-8));
  CHECK(law.relative_error == doctest::Approx(0));
  const double exponent = fit_power(samples).exponent;
  CHECK(exponent > 1.05);
  CHECK(exponent < 1.2);
  CHECK(log_linear_exponent(samples) == doctest::Approx(exponent));
}

TEST_CASE("a factor too much and too little in turn: the law in the middle, and its error") {
  double factor = 1.1;
  const auto samples = samples_of([&](double n) { return 2 * n * (factor = 1 / factor); });
  CHECK(fit_power(samples).relative_error == doctest::Approx(std::log(1.1)).epsilon(0.05));
  const auto squares = samples_of([](double n) { return n * n; });
  CHECK(fit_log_linear(squares).relative_error > 1);
}

TEST_CASE("costs of zero do not count") {
  auto samples = samples_of([](double n) { return 4 * n; });
  samples[0].cost = samples[1].cost = 0;
  CHECK(fit_power(samples).exponent == doctest::Approx(1));
  CHECK(fit_power(samples).factor == doctest::Approx(4));
}

TEST_CASE("too few samples for a law") {
  CHECK(fit_power({}).exponent == 0);
  CHECK(fit_log_linear({}).factor == 0);
  const std::vector<Sample> one{{1024, 2}};
  CHECK(fit_power(one).factor == 0);
  CHECK(fit_log_linear(one).factor == doctest::Approx(2.0 / 10240));
}

}  // namespace
}  // namespace tetsculpt::bench
