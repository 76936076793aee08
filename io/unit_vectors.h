#pragma once

#include "kernel/point.h"
#include "kernel/vec3.h"

/// Directions for the eye: rounded, but right for coordinates of any size.
namespace tetsculpt {

/// `v` over its length; no component's square over- or underflows. Zero for the zero vector.
/// Precondition: v is finite.
Vec3<double> unit(const Vec3<double>& v);

/// The direction from a to b, likewise: the difference may overflow. Zero if they are equal.
Vec3<double> direction(const Point3& a, const Point3& b);

/// The unit normal of the triangle, on the side from which a, b, c look counterclockwise; zero if
/// it has no area.
Vec3<double> unit_normal(const Point3& a, const Point3& b, const Point3& c);

}  // namespace tetsculpt
