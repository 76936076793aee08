// Simulation of simplicity on the lift: H. Edelsbrunner, E. P. Muecke, "Simulation of simplicity",
// ACM Transactions on Graphics 9(1), 1990; for the lift alone, O. Devillers, M. Teillaud,
// "Perturbations for Delaunay and weighted Delaunay 3D triangulations", Computational Geometry
// 44(3), 2011.
#include "kernel/perturbation.h"

#include <algorithm>
#include <array>

#include "kernel/predicates.h"

namespace tetsculpt {
namespace {

/// A point whose eps may decide, and its place among the arguments.
struct Ranked {
  const Point3* point;
  int argument;
};

/// Puts the dominant eps, that of the lexicographically greatest point, first.
template <std::size_t N>
void sort_by_rank(std::array<Ranked, N>& points) {
  std::sort(points.begin(), points.end(), [](const Ranked& p, const Ranked& q) {
    return lexicographically_less(*q.point, *p.point);
  });
}

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
  std::array<Ranked, 5> points{{{&a, 0}, {&b, 1}, {&c, 2}, {&d, 3}, {&e, 4}}};
  sort_by_rank(points);
  const auto coefficient = [&](int argument) {
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
  for (const Ranked& r : points) {
    const Sign s = coefficient(r.argument);
    if (s != Sign::kZero) return s == Sign::kPositive;
  }
  return false;
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
  std::array<Ranked, 4> points{{{&a, 0}, {&b, 1}, {&c, 2}, {&p, 3}}};
  sort_by_rank(points);
  for (const Ranked& r : points) {
    if (r.argument == 3) return false;
    const Sign lambda = r.argument == 0   ? barycentric_sign(a, b, c, p)
                        : r.argument == 1 ? barycentric_sign(b, c, a, p)
                                          : barycentric_sign(c, a, b, p);
    if (lambda != Sign::kZero) return lambda == Sign::kPositive;
  }
  return false;
}

}  // namespace tetsculpt
