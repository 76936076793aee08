// Simulation of simplicity on the lift: H. Edelsbrunner, E. P. Muecke, "Simulation of simplicity",
// ACM Transactions on Graphics 9(1), 1990; for the lift alone, O. Devillers, M. Teillaud,
// "Perturbations for Delaunay and weighted Delaunay 3D triangulations", Computational Geometry
// 44(3), 2011.
#include "kernel/perturbation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "kernel/predicates.h"

namespace tetsculpt {
namespace {

/// Hands out the places of some points among the arguments, that of the dominant eps, the
/// lexicographically greatest point's, first. Mostly the first decides, and a sort would be waste.
template <std::size_t N>
class Dominance {
 public:
  template <class... Points>
  explicit Dominance(const Points&... points) : points_{&points...}, x_{points.x...} {}

  /// Precondition: called at most N times.
  std::size_t next() {
    double greatest = x_[0];
    for (std::size_t i = 1; i < N; ++i) greatest = std::max(greatest, x_[i]);
    std::size_t best = N;
    for (std::size_t i = 0; i < N; ++i) {
      if (x_[i] == greatest && (best == N || lexicographically_less(*points_[best], *points_[i]))) {
        best = i;
      }
    }
    x_[best] = -HUGE_VAL;
    return best;
  }

 private:
  std::array<const Point3*, N> points_;
  std::array<double, N> x_;  ///< less than all coordinates once it has been handed out
};

}  // namespace

bool in_perturbed_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                         const Point3& e) {
  const Sign side = insphere(a, b, c, d, e);
  return side == Sign::kZero ? perturbed_inside(a, b, c, d, e) : side == Sign::kPositive;
}

// The insphere determinant is linear in the lifts. The coefficient of eps_a is -orient3d(b, c, d,
// e) and so on with alternating signs; that of eps_e is -orient3d(a, b, c, d), which is negative:
// so the loop ends at e at the latest.
bool perturbed_inside(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                      const Point3& e) {
  const auto coefficient = [&](std::size_t argument) {
    switch (argument) {
      case 0:
        return -orient3d(b, c, d, e);
      case 1:
        return orient3d(c, d, a, e);
      case 2:
        return -orient3d(d, a, b, e);
      case 3:
        return orient3d(a, b, c, e);
      default:
        return Sign::kNegative;
    }
  };
  Dominance<5> order(a, b, c, d, e);
  Sign s = Sign::kZero;
  while (s == Sign::kZero) s = coefficient(order.next());
  return s == Sign::kPositive;
}

bool in_perturbed_diametral_sphere(const Point3& a, const Point3& b, const Point3& p) {
  const Sign side = in_diametral_sphere(a, b, p);
  if (side != Sign::kZero) return side == Sign::kPositive;
  return lexicographically_less(p, a) || lexicographically_less(p, b);
}

bool in_perturbed_equatorial_sphere(const Point3& a, const Point3& b, const Point3& c,
                                    const Point3& p) {
  const Sign side = in_equatorial_sphere(a, b, c, p);
  if (side != Sign::kZero) return side == Sign::kPositive;
  Dominance<4> order(a, b, c, p);
  for (;;) {
    const std::size_t argument = order.next();
    if (argument == 3) return false;
    const Sign lambda = argument == 0   ? barycentric_sign(a, b, c, p)
                        : argument == 1 ? barycentric_sign(b, c, a, p)
                                        : barycentric_sign(c, a, b, p);
    if (lambda != Sign::kZero) return lambda == Sign::kPositive;
  }
}

}  // namespace tetsculpt
