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

struct SimplicesOptions {
  int threads = 1;  ///< at most so many; the result does not depend on it
  /// Takes vectors of eight numbers where the processor has them; the result does not depend on it.
  bool by_eight = true;
  /// Told now and then, on the caller's thread, which share is done. May throw.
  std::function<void(double)> progress = {};
};

/// Numbers triangles and edges in the order in which the finite tetrahedra have them. What has a
/// corner at infinity gets no id. Throws std::length_error where there are too many for their ids,
/// about 2^31 edges or 2^32 / 6 tetrahedra. Cost: linear.
Simplices find_simplices(const LiftedHull& hull, const SimplicesOptions& options = {});

}  // namespace tetsculpt
