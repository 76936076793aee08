#pragma once

#include <span>
#include <vector>

#include "kernel/ids.h"
#include "kernel/point.h"
#include "kernel/vec3.h"
#include "kernel/vertex_stars.h"
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

/// One pair per vertex. Cost: linear in the complex.
std::vector<PolePair> poles(std::span<const Point3> points, const TetComplex& complex,
                            const VertexStars& stars, const Circumspheres& spheres);

}  // namespace tetsculpt
