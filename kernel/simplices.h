#pragma once

#include <array>
#include <functional>

#include "kernel/ids.h"
#include "kernel/large_array.h"
#include "kernel/lifted_hull.h"

/// The triangles and edges of a tetrahedralization. Internal to kernel/tet_complex.
namespace tetsculpt {

struct Simplices {
  struct Edge {
    std::array<VertexId, 2> vertices;  ///< lower id first
    TriangleId triangle;               ///< one at it
  };
  /// Per tetrahedron and corner, the triangle opposite.
  LargeArray<std::array<TriangleId, 4>> triangles_of_tet;
  LargeArray<std::array<EdgeId, 6>> edges_of_tet;
  LargeArray<FacetHandle> facet_of_triangle;  ///< in the first tetrahedron at it
  LargeArray<Edge> edges;
};

/// Numbers triangles and edges in the order in which the finite tetrahedra have them. What has a
/// corner at infinity gets no id.
/// `progress` is told now and then, on the caller's thread, which share is done, and may throw. The
/// result does not depend on `threads`.  Cost: linear.
Simplices find_simplices(const LiftedHull& hull, int threads,
                         const std::function<void(double)>& progress);

}  // namespace tetsculpt
