#pragma once

#include <optional>

#include "kernel/point.h"
#include "kernel/sign.h"

/// Exact geometric predicates. Each is the sign of a polynomial in the input coordinates, decided
/// by a ladder: a floating-point filter, an exact evaluation of the rounded differences with an
/// error bound, and an exact evaluation with floating-point expansions.  [Shewchuk 1997]
///
/// Precondition of all: coordinates are finite and within the domain of kernel/distinct_points.h
/// (magnitude below 2^168, no set bit below 2^-179); there the answer is always exact.
/// Cost: the filter alone (15 to 90 flops) unless near-degenerate.
namespace tetsculpt {

/// Side of the plane abc on which d lies. kPositive: below, where a, b, c look counterclockwise
/// from above; kZero if and only if the four points are coplanar.
///   (1) Swapping two arguments flips the sign.
/// Degree 3.
Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// kPositive if e lies strictly inside the sphere through a, b, c, d, given
/// orient3d(a, b, c, d) == kPositive (the sign flips with that orientation); kZero if and only if
/// the five points are cospherical or a, b, c, d, e are all coplanar.
///   (1) Swapping any two of the five arguments flips the sign.
/// Degree 5.
Sign insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e);

/// The same for points all coordinates of which are multiples of 1 / per_unit, a power of two;
/// nothing if they are too many units apart. Exact without a search for that unit: on 206,232
/// cospherical points of a lattice a quarter of the hull's time.
std::optional<Sign> insphere_in_units(const Point3& a, const Point3& b, const Point3& c,
                                      const Point3& d, const Point3& e, double per_unit);

/// kPositive if p lies strictly inside the ball with diameter ab, kZero on its boundary.
///   (1) Symmetric in a and b.
/// Degree 2.
Sign in_diametral_sphere(const Point3& a, const Point3& b, const Point3& p);

/// kPositive if p lies strictly inside the smallest sphere that passes through a, b and c (centred
/// in their plane), kZero on it.  Precondition: a, b, c are not collinear (collinear: kZero).
///   (1) Symmetric in a, b and c.
/// Degree 6.
Sign in_equatorial_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& p);

/// Sign of the barycentric coordinate that belongs to a, of the orthogonal projection of p on the
/// plane abc.  kZero if the projection is on the line bc.
///   (1) Symmetric in b and c.
/// Degree 4.
Sign barycentric_sign(const Point3& a, const Point3& b, const Point3& c, const Point3& p);

/// kPositive if ab is longer than cd, kZero if they are equally long. Degree 2.
Sign compare_lengths(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// True if and only if a, b, c lie on one line. Degree 2.
bool collinear(const Point3& a, const Point3& b, const Point3& c);

}  // namespace tetsculpt
