#pragma once

#include <span>
#include <vector>

#include "kernel/ids.h"
#include "kernel/large_array.h"
#include "kernel/point.h"
#include "kernel/tet_complex.h"
#include "kernel/vec3.h"

/// The spheres around the tetrahedra, whose centres are the Voronoi vertices. In floating point:
/// they are evidence, never a decision about the complex. Their rounding depends on the order of a
/// tetrahedron's corners, which lifted_hull makes a function of the points.
namespace tetsculpt {

class Circumspheres {
 public:
  /// Cost: linear, some 60 flops per tetrahedron. Keeps a reference to the complex.
  Circumspheres(std::span<const Point3> points, const TetComplex& complex);

  /// Of a finite tetrahedron; of use only if the radius is finite.
  const Vec3<double>& centre(TetId t) const { return balls_[+t].centre; }
  /// Infinite where the tetrahedron is flat to rounding; never NaN.
  double radius(TetId t) const { return balls_[+t].radius; }
  /// Outward unit normal of an infinite tetrahedron's hull triangle: its "sphere" is the half-space
  /// beyond.
  const Vec3<double>& outward(TetId t) const { return balls_[+t].centre; }

  /// Cosine of the angle at which the spheres on both sides of a facet meet: 1 if they coincide, -1
  /// if they touch from outside; 0 where a sphere is not finite.  [Amenta, Choi, Kolluri 2001]
  double overlap(TetId t, int corner) const;

 private:
  struct Ball {
    Vec3<double> centre;
    double radius;
  };
  Ball finite_ball(TetId t) const;
  Ball half_space(TetId t) const;
  double overlap_with_outside(TetId finite, int corner, TetId infinite) const;

  std::span<const Point3> points_;
  const TetComplex* complex_;
  LargeArray<Ball> balls_;
};

/// b - a.
inline Vec3<double> from_to(const Point3& a, const Point3& b) {
  return {b.x - a.x, b.y - a.y, b.z - a.z};
}
inline Vec3<double> from_to(const Vec3<double>& a, const Vec3<double>& b) {
  return {b.x - a.x, b.y - a.y, b.z - a.z};
}
inline Vec3<double> as_vector(const Point3& p) { return {p.x, p.y, p.z}; }
/// Per triangle, the overlap of the spheres on its two sides. Cost: linear.
LargeArray<float> overlaps(const TetComplex& complex, const Circumspheres& spheres);

inline double length(const Vec3<double>& a) { return std::sqrt(dot(a, a)); }

}  // namespace tetsculpt
