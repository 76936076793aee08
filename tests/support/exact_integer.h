#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "kernel/sign.h"

namespace tetsculpt::exact {

/// A signed integer without rounding: the arithmetic of the oracles, kept free of every trick that
/// the kernel uses. Sign and magnitude; limbs_[0] is the least significant.
///   (1) The last of the size_ limbs in use is not zero; the others are never read.
///   (2) Zero is not negative.
/// Throws std::length_error beyond 2304 bits; degree 6 in differences of 348 bits needs less.
class ExactInteger {
 public:
  ExactInteger() {}  // the limbs stay as they are: most numbers use few of them
  ExactInteger(const ExactInteger& other) { *this = other; }

  ExactInteger& operator=(const ExactInteger& other) {
    size_ = other.size_;
    negative_ = other.negative_;
    std::copy_n(other.limbs_.begin(), size_, limbs_.begin());
    return *this;
  }

  explicit ExactInteger(std::int64_t value) : negative_(value < 0) {
    const auto bits = static_cast<std::uint64_t>(value);
    assign_shifted(negative_ ? 0 - bits : bits, 0);
  }

  /// x / 2^unit_exponent. Throws std::domain_error if that isn't an integer.
  static ExactInteger from_double(double x, int unit_exponent) {
    ExactInteger result;
    if (x == 0) return result;
    int exponent = 0;
    const double fraction = std::frexp(std::fabs(x), &exponent);
    const auto mantissa = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
    const int trailing = std::countr_zero(mantissa);
    const int shift = exponent - 53 + trailing - unit_exponent;
    if (shift < 0) throw std::domain_error("not a multiple of the unit");
    result.assign_shifted(mantissa >> trailing, static_cast<std::size_t>(shift));
    result.negative_ = x < 0;
    return result;
  }

  Sign sign() const {
    return size_ == 0 ? Sign::kZero : negative_ ? Sign::kNegative : Sign::kPositive;
  }

  friend bool operator==(const ExactInteger& a, const ExactInteger& b) {
    return a.negative_ == b.negative_ && a.size_ == b.size_ &&
           std::equal(a.limbs_.begin(), a.limbs_.begin() + a.size_, b.limbs_.begin());
  }

  friend ExactInteger operator-(ExactInteger a) {
    a.negative_ = a.size_ != 0 && !a.negative_;
    return a;
  }

  friend ExactInteger operator+(const ExactInteger& a, const ExactInteger& b) {
    return sum(a, b, b.negative_);
  }

  friend ExactInteger operator-(const ExactInteger& a, const ExactInteger& b) {
    return sum(a, b, !b.negative_);
  }

  friend ExactInteger operator*(const ExactInteger& a, const ExactInteger& b) {
    ExactInteger result;
    if (a.size_ + b.size_ > kCapacity) throw std::length_error("ExactInteger: product");
    std::fill_n(result.limbs_.begin(), a.size_ + b.size_, Limb{0});
    for (std::size_t i = 0; i < a.size_; ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < b.size_; ++j) {
        carry += std::uint64_t{a.limbs_[i]} * b.limbs_[j] + result.limbs_[i + j];
        result.limbs_[i + j] = static_cast<Limb>(carry);
        carry >>= kLimbBits;
      }
      result.limbs_[i + b.size_] = static_cast<Limb>(carry);
    }
    result.negative_ = a.negative_ != b.negative_;
    result.trim(a.size_ + b.size_);
    return result;
  }

 private:
  using Limb = std::uint32_t;
  static constexpr int kLimbBits = 32;
  static constexpr std::size_t kCapacity = 72;

  /// Sets the magnitude, from zero, to value * 2^shift.
  void assign_shifted(std::uint64_t value, std::size_t shift) {
    const std::size_t first = shift / kLimbBits;
    if (first + 3 > kCapacity) throw std::length_error("ExactInteger: shift");
    std::fill_n(limbs_.begin(), first, Limb{0});
    const std::size_t within = shift % kLimbBits;
    const std::uint64_t low = (value & 0xffffffffU) << within;
    const std::uint64_t high = ((value >> kLimbBits) << within) + (low >> kLimbBits);
    limbs_[first] = static_cast<Limb>(low);
    limbs_[first + 1] = static_cast<Limb>(high);
    limbs_[first + 2] = static_cast<Limb>(high >> kLimbBits);
    trim(first + 3);
  }

  void trim(std::size_t size) {
    while (size > 0 && limbs_[size - 1] == 0) --size;
    size_ = size;
    if (size == 0) negative_ = false;
  }

  static bool magnitude_less(const ExactInteger& a, const ExactInteger& b) {
    if (a.size_ != b.size_) return a.size_ < b.size_;
    std::size_t i = a.size_;
    while (i > 0 && a.limbs_[i - 1] == b.limbs_[i - 1]) --i;
    return i > 0 && a.limbs_[i - 1] < b.limbs_[i - 1];
  }

  /// a plus the number with the magnitude of b and the given sign.
  static ExactInteger sum(const ExactInteger& a, const ExactInteger& b, bool b_negative) {
    const bool swapped = magnitude_less(a, b);
    const ExactInteger& greater = swapped ? b : a;
    const ExactInteger& less = swapped ? a : b;
    ExactInteger result;
    result.negative_ = swapped ? b_negative : a.negative_;
    if (a.negative_ == b_negative) {
      result.assign_sum(greater, less);
    } else {
      result.assign_difference(greater, less);
    }
    return result;
  }

  /// Sets the magnitude to |a| + |b|, where |a| >= |b|.
  void assign_sum(const ExactInteger& a, const ExactInteger& b) {
    if (a.size_ == kCapacity) throw std::length_error("ExactInteger: sum");
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < a.size_; ++i) {
      carry += std::uint64_t{a.limbs_[i]} + (i < b.size_ ? b.limbs_[i] : 0);
      limbs_[i] = static_cast<Limb>(carry);
      carry >>= kLimbBits;
    }
    limbs_[a.size_] = static_cast<Limb>(carry);
    trim(a.size_ + 1);
  }

  /// Sets the magnitude to |a| - |b|, where |a| >= |b|.
  void assign_difference(const ExactInteger& a, const ExactInteger& b) {
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < a.size_; ++i) {
      const std::uint64_t limb =
          std::uint64_t{a.limbs_[i]} - (i < b.size_ ? b.limbs_[i] : 0) - borrow;
      limbs_[i] = static_cast<Limb>(limb);
      borrow = (limb >> kLimbBits) & 1;
    }
    trim(a.size_);
  }

  std::size_t size_ = 0;
  bool negative_ = false;
  std::array<Limb, kCapacity> limbs_;
};

}  // namespace tetsculpt::exact
