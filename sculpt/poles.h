#pragma once

#include <span>

#include "kernel/ids.h"
#include "kernel/large_array.h"
#include "kernel/point.h"
#include "kernel/tet_complex.h"
#include "kernel/vec3.h"
#include "sculpt/circumspheres.h"

/// Poles: where a vertex's Voronoi cell is longest, which is along the surface normal.
namespace tetsculpt {

/// The two poles of a vertex lie on different sides of a well-sampled surface.
/// [Amenta, Choi, Kolluri 2001]
struct PolePair {
  /// The farthest Voronoi vertex; an infinite tetrahedron for a vertex of the hull.
  TetId first{};
  /// The farthest in the half-space opposite to it.
  TetId second{};
  /// Direction from the vertex to its first pole, of length one.
  Vec3<double> axis{};
  /// Minus the cosine of the angle between the poles at the vertex, in [0, 1]; 0 if there is no
  /// second.
  double strength = 0;
};

/// One pair per vertex; of equally far ones the tetrahedron with the lower id. Cost: two passes
/// over the complex.
LargeArray<PolePair> poles(std::span<const Point3> points, const TetComplex& complex,
                           const Circumspheres& spheres);

}  // namespace tetsculpt
