#pragma once

#include <functional>

#include "kernel/distinct_points.h"
#include "kernel/tet_complex.h"

/// The Delaunay tetrahedralization of a point set.
namespace tetsculpt {

struct DelaunayOptions {
  int threads = 1;  ///< at most so many; the result does not depend on it
  /// Told now and then, on the caller's thread, which share of the work is done, from 0 to 1. May
  /// throw: that cancels, and the exception passes through.
  std::function<void(double)> progress = {};
};

/// DT(P), ties broken by kernel/perturbation: one function of the point set. No tetrahedron is
/// flat, and every point is a vertex. Without any simplex if the points do not span a solid (all
/// equal, on a line, or in a plane; first_simplex tells which). Cost: see kernel/lifted_hull.h.
TetComplex delaunay(const DistinctPoints& points, const DelaunayOptions& options = {});

}  // namespace tetsculpt
