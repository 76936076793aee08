#pragma once

/// The sign of an exactly evaluated polynomial: the only thing geometric code branches on.
namespace tetsculpt {

enum class Sign : signed char { kNegative = -1, kZero = 0, kPositive = 1 };

template <class Number>
constexpr Sign sign_of(const Number& x) {
  return x > 0 ? Sign::kPositive : x < 0 ? Sign::kNegative : Sign::kZero;
}

constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }

}  // namespace tetsculpt
