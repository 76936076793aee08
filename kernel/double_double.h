#pragma once

#include "kernel/two_terms.h"

namespace tetsculpt {

/// A number of twice a double's digits: high + low, |low| at most half an ulp of high. Results are
/// off by at most kRounding times themselves. [M. Joldes, J.-M. Muller, V. Popescu, "Tight and
/// rigorous error bounds for basic building blocks of double-word arithmetic", ACM Transactions on
/// Mathematical Software 44(2), 2017: algorithms 6 and 11, at most 3 and 5 times 2^-106]
struct DoubleDouble : TwoTerms {
  static constexpr double kRounding = 0x1p-103;

  /// Exact.
  static DoubleDouble difference(double a, double b) { return {two_sum(a, -b)}; }

  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const TwoTerms highs = two_sum(a.high, b.high);
    const TwoTerms lows = two_sum(a.low, b.low);
    const TwoTerms sum = fast_two_sum(highs.high, highs.low + lows.high);
    return {fast_two_sum(sum.high, lows.low + sum.low)};
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
    return a + DoubleDouble{{-b.high, -b.low}};
  }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const TwoTerms product = two_product(a.high, b.high, split(b.high));
    return {fast_two_sum(product.high, product.low + (a.high * b.low + a.low * b.high))};
  }
};

}  // namespace tetsculpt
