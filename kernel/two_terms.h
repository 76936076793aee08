#pragma once

/// Sums and products of doubles without error, as a double and what was rounded off. [T. J. Dekker,
/// "A floating-point technique for extending the available precision", Numerische Mathematik 18,
/// 1971] By Dekker's splitting, not a fused multiply-add, so that every x86-64 and ARM build
/// computes alike. Exact as long as nothing overflows or falls below 2^-1074; needs IEEE semantics,
/// which kernel/expansion.cpp checks.
namespace tetsculpt {

struct TwoTerms {
  double high;
  double low;
};

/// a + b, for |a| >= |b|.
inline TwoTerms fast_two_sum(double a, double b) {
  const double high = a + b;
  return {high, b - (high - a)};
}

inline TwoTerms two_sum(double a, double b) {
  const double high = a + b;
  const double b_part = high - a;
  return {high, (a - (high - b_part)) + (b - b_part)};
}

inline TwoTerms split(double a) {
  constexpr double kSplitter = 134217729.0;  // 2^27 + 1
  const double c = kSplitter * a;
  const double high = c - (c - a);
  return {high, a - high};
}

/// a * b, where b is split already.
inline TwoTerms two_product(double a, double b, TwoTerms b_split) {
  const TwoTerms s = split(a);
  const double high = a * b;
  const double error =
      ((high - s.high * b_split.high) - s.low * b_split.high) - s.high * b_split.low;
  return {high, s.low * b_split.low - error};
}

}  // namespace tetsculpt
