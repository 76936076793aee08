#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "kernel/sign.h"

/// Floating-point expansions: exact sums of doubles, for polynomials whose sign a filter can't
/// decide. [Shewchuk 1997]
///
/// An expansion is a list of nonoverlapping doubles in increasing magnitude without zeros; its
/// value is their exact sum. Sums, differences and products of expansions are exact as long as no
/// component overflows or falls below 2^-1074, which the domain of kernel/predicates.h guarantees.
namespace tetsculpt {

/// Storage of the expansions of one computation. The first 4096 doubles are on the stack.
class ExpansionArena {
 public:
  ExpansionArena() = default;
  ExpansionArena(const ExpansionArena&) = delete;
  ExpansionArena& operator=(const ExpansionArena&) = delete;

  /// Room for n doubles; the next reserve() may hand it out again from where commit() says.
  double* reserve(std::size_t n);
  /// Keeps the first n doubles of the room last reserved.
  void commit(std::size_t n) { top_ += n; }

 private:
  std::array<double, 4096> first_;
  std::vector<std::unique_ptr<double[]>> more_;
  double* top_ = first_.data();
  double* end_ = first_.data() + first_.size();
};

/// A value in an arena that outlives it. Copies share the components.
class Expansion {
 public:
  /// The exact difference a - b: one component if that is a double, else two.
  static Expansion difference(double a, double b, ExpansionArena& arena);
  static Expansion number(double a, ExpansionArena& arena);

  friend Expansion operator+(const Expansion& e, const Expansion& f);
  friend Expansion operator-(const Expansion& e, const Expansion& f);
  friend Expansion operator*(const Expansion& e, const Expansion& f);

  std::size_t size() const { return size_; }
  Sign sign() const { return size_ == 0 ? Sign::kZero : sign_of(components_[size_ - 1]); }
  /// The value to within a few ulps.
  double estimate() const;

 private:
  Expansion(const double* components, std::size_t size, ExpansionArena* arena)
      : components_(components), size_(size), arena_(arena) {}
  static Expansion sum(const Expansion& e, const Expansion& f, double f_sign);
  static Expansion scaled(const Expansion& e, double factor);

  const double* components_;
  std::size_t size_;
  ExpansionArena* arena_;
};

}  // namespace tetsculpt
