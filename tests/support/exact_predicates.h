#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "kernel/point.h"
#include "kernel/sign.h"

/// Oracles for kernel/predicates.h and kernel/perturbation.h: every answer follows from a
/// definition (a side, a power, a projection), not from the kernel's formulas, and is computed with
/// integers that never round. The names and contracts are the kernel's.
namespace tetsculpt::exact {

Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
Sign insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e);
Sign in_diametral_sphere(const Point3& a, const Point3& b, const Point3& p);
Sign in_equatorial_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& p);
Sign barycentric_sign(const Point3& a, const Point3& b, const Point3& c, const Point3& p);
Sign compare_lengths(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
bool collinear(const Point3& a, const Point3& b, const Point3& c);

/// How the perturbed power of a point was decided. The power is a real number plus a linear form in
/// the eps of the points: inside means that it is negative.
struct PerturbedSide {
  bool inside = false;
  /// -1: the unperturbed power decided. Otherwise the place, in decreasing lexicographic order, of
  /// the point whose coefficient decided; the coefficients of those before are zero.
  int rank = -1;
  /// The argument to which that point belongs; the last one is the point tested.
  std::size_t argument = 0;
};

/// Precondition: orient3d(a, b, c, d) == Sign::kPositive.
PerturbedSide in_perturbed_sphere(const Point3& a, const Point3& b, const Point3& c,
                                  const Point3& d, const Point3& e);
PerturbedSide in_perturbed_diametral_sphere(const Point3& a, const Point3& b, const Point3& p);
PerturbedSide in_perturbed_equatorial_sphere(const Point3& a, const Point3& b, const Point3& c,
                                             const Point3& p);

/// Six times the volume of abcd if all coordinates are small integers.
std::int64_t six_volumes(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// Compares a predicate with its oracle over many cases: one failure count, the first failing case
/// in words, and how often each of the oracle's answers occurred.
class Agreement {
 public:
  void add(Sign expected, Sign actual, std::span<const Point3> points);

  std::int64_t failures() const { return failures_; }
  std::int64_t occurrences(Sign s) const { return count_[static_cast<std::size_t>(int(s) + 1)]; }
  /// Each of the three answers makes up at least `percent` percent of the cases.
  bool covers_all_signs(int percent) const;
  /// Counts per answer and, if any, the first failing case with its coordinates in hexadecimal.
  std::string summary() const;

 private:
  std::array<std::int64_t, 3> count_{};
  std::int64_t failures_ = 0;
  std::string first_failure_;
};

}  // namespace tetsculpt::exact
