#pragma once

#include "kernel/point.h"

/// The one place where ties are broken: a symbolic perturbation of the lift alone.
///
/// Point p is lifted to (p, |p|^2 + eps_p) with infinitesimal positive eps_p, where the eps of a
/// lexicographically greater point dominates all those of smaller ones. Cospherical sets get one
/// well-defined answer that depends on nothing but the points; coplanar points stay coplanar,
/// because orient3d is not perturbed.  [Edelsbrunner, Muecke 1990; Devillers, Teillaud 2011]
///
/// Precondition of all: the points are pairwise distinct and in the domain of kernel/predicates.h.
namespace tetsculpt {

/// True if the perturbed e is inside the sphere of the perturbed tetrahedron abcd.
/// Precondition: orient3d(a, b, c, d) == Sign::kPositive. Never undecided.
bool in_perturbed_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                         const Point3& e);

/// The tie rule of in_perturbed_sphere alone. Precondition: insphere(a, b, c, d, e) is kZero.
bool perturbed_inside(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                      const Point3& e);

/// True if the perturbed p is inside the smallest sphere of the edge ab. On the sphere itself p is
/// inside exactly if it is not the lexicographically greatest of the three.
bool in_perturbed_diametral_sphere(const Point3& a, const Point3& b, const Point3& p);

/// True if the perturbed p is inside the smallest sphere through a, b, c. On the sphere itself p is
/// inside exactly if eps_p - (la eps_a + lb eps_b + lc eps_c) is negative, where la, lb, lc are the
/// barycentric coordinates of p's projection on their plane.  Precondition: not collinear.
bool in_perturbed_equatorial_sphere(const Point3& a, const Point3& b, const Point3& c,
                                    const Point3& p);

}  // namespace tetsculpt
