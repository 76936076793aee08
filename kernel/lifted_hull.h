#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "kernel/ids.h"
#include "kernel/large_array.h"
#include "kernel/point.h"

/// Delaunay tetrahedralization as the lower convex hull of the points lifted to a paraboloid in 4D.
namespace tetsculpt {

/// One facet of a tetrahedron: 4 * tetrahedron + the corner opposite the facet.
using FacetHandle = std::uint32_t;

/// The tetrahedra, finite ones first, then one infinite tetrahedron per triangle of the convex
/// hull.
struct LiftedHull {
  /// Corners, in ascending order but for the last two, whose order gives the orientation. Finite
  /// tetrahedra are positively oriented (orient3d of the corners is kPositive); one corner of an
  /// infinite one is kInfinite. A triangle has opposite orientations in its two sides.
  LargeArray<std::array<VertexId, 4>> tets;
  /// Per corner i, the facet opposite i as its other side sees it.
  LargeArray<std::array<FacetHandle, 4>> neighbors;
  std::size_t finite_count = 0;
};

struct LiftedHullOptions {
  int threads = 1;  ///< at most so many; the result does not depend on it
  /// Takes vectors of four numbers where the processor has them; the result does not depend on it.
  bool four_lanes = true;
  /// Told now and then, on the caller's thread, which share of the work is done, from 0 to 1. May
  /// throw: that cancels, and the exception passes through.
  std::function<void(double)> progress = {};
};

/// Quickhull on the lifted points and the point at infinity above them. The perturbation makes all
/// points extreme and the result one function of the point set.
/// Precondition: `points` are distinct, along a Hilbert curve and in the exact domain, as
/// kernel/distinct_points has them. Empty if no four of them span a solid.
/// [Barber, Dobkin, Huhdanpaa 1996; Brown 1979]
/// Cost: O(n log n) expected plus linear in the tetrahedra created.
LiftedHull lifted_hull(std::span<const Point3> points, const LiftedHullOptions& options = {});

}  // namespace tetsculpt
