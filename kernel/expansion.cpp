// Expansion arithmetic after J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast
// robust geometric predicates", Discrete & Computational Geometry 18, 1997, section 2.
#include "kernel/expansion.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "kernel/two_terms.h"

#ifdef __FAST_MATH__
#error "exact arithmetic needs IEEE semantics: build without -ffast-math"
#endif
static_assert(FLT_EVAL_METHOD == 0, "exact arithmetic needs doubles that are rounded to double");

namespace tetsculpt {
namespace {

/// Appends components to an expansion under construction, leaving zeros out.
struct Writer {
  double* to;
  std::size_t size = 0;
  void put(double x) {
    if (x != 0) to[size++] = x;
  }
};

}  // namespace

double* ExpansionArena::reserve(std::size_t n) {
  if (static_cast<std::size_t>(end_ - top_) < n) {
    const std::size_t chunk = std::max<std::size_t>(n, 1u << 16);
    more_.push_back(std::make_unique_for_overwrite<double[]>(chunk));
    top_ = more_.back().get();
    end_ = top_ + chunk;
  }
  return top_;
}

Expansion Expansion::difference(double a, double b, ExpansionArena& arena) {
  const TwoTerms d = two_sum(a, -b);
  Writer out{arena.reserve(2)};
  out.put(d.low);
  out.put(d.high);
  arena.commit(out.size);
  return {out.to, out.size, &arena};
}

Expansion Expansion::number(double a, ExpansionArena& arena) { return difference(a, 0.0, arena); }

/// e + f_sign * f by merging the components in order of magnitude (FAST-EXPANSION-SUM).
Expansion Expansion::sum(const Expansion& e, const Expansion& f, double f_sign) {
  ExpansionArena& arena = *e.arena_;
  Writer out{arena.reserve(e.size_ + f.size_)};
  std::size_t i = 0;
  std::size_t j = 0;
  const auto next = [&] {
    if (j == f.size_ ||
        (i < e.size_ && std::fabs(e.components_[i]) < std::fabs(f.components_[j]))) {
      return e.components_[i++];
    }
    return f_sign * f.components_[j++];
  };
  if (e.size_ + f.size_ > 0) {
    double carry = next();
    for (bool first = true; i + j < e.size_ + f.size_; first = false) {
      const double term = next();
      const TwoTerms s = first ? fast_two_sum(term, carry) : two_sum(carry, term);
      out.put(s.low);
      carry = s.high;
    }
    out.put(carry);
  }
  arena.commit(out.size);
  return {out.to, out.size, &arena};
}

/// e times one double (SCALE-EXPANSION).
Expansion Expansion::scaled(const Expansion& e, double factor) {
  ExpansionArena& arena = *e.arena_;
  Writer out{arena.reserve(2 * e.size_)};
  if (e.size_ > 0) {
    const TwoTerms factor_split = split(factor);
    TwoTerms carry = two_product(e.components_[0], factor, factor_split);
    out.put(carry.low);
    for (std::size_t i = 1; i < e.size_; ++i) {
      const TwoTerms term = two_product(e.components_[i], factor, factor_split);
      const TwoTerms s = two_sum(carry.high, term.low);
      out.put(s.low);
      carry = fast_two_sum(term.high, s.high);
      out.put(carry.low);
    }
    out.put(carry.high);
  }
  arena.commit(out.size);
  return {out.to, out.size, &arena};
}

Expansion operator+(const Expansion& e, const Expansion& f) { return Expansion::sum(e, f, 1.0); }
Expansion operator-(const Expansion& e, const Expansion& f) { return Expansion::sum(e, f, -1.0); }

Expansion operator*(const Expansion& e, const Expansion& f) {
  const Expansion& longer = e.size_ < f.size_ ? f : e;
  const Expansion& shorter = e.size_ < f.size_ ? e : f;
  if (shorter.size_ == 0) return shorter;
  Expansion product = Expansion::scaled(longer, shorter.components_[0]);
  for (std::size_t i = 1; i < shorter.size_; ++i) {
    product = product + Expansion::scaled(longer, shorter.components_[i]);
  }
  return product;
}

double Expansion::estimate() const {
  double value = 0;
  for (std::size_t i = 0; i < size_; ++i) value += components_[i];
  return value;
}

}  // namespace tetsculpt
