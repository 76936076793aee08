#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "kernel/edge_order.h"
#include "kernel/large_array.h"
#include "kernel/tet_complex.h"
#include "kernel/vertex_stars.h"

/// Counts into how many parts a set of tetrahedra divides the star of a vertex.
namespace tetsculpt {

/// Parts of one star: tetrahedra on one side that are connected through facets at the vertex.
struct StarParts {
  int inside = 0;
  int outside = 0;
  /// 0 exactly if the star is good: at most one part on each side. The boundary of a set of
  /// tetrahedra is a 2-manifold exactly if all stars are good.
  int excess() const { return std::max(inside - 1, 0) + std::max(outside - 1, 0); }
  /// The vertex is not on the boundary.
  bool one_sided() const { return inside == 0 || outside == 0; }
};

/// Holds the scratch space of the search. Keeps references to its arguments.
class StarInspector {
 public:
  StarInspector(const TetComplex& complex, const VertexStars& stars)
      : complex_(complex), stars_(stars), seen_(complex.tet_count(), 0) {}

  /// Cost: linear in the star; no allocation once warm.
  StarParts parts(VertexId v, const Flags& inside);

 private:
  const TetComplex& complex_;
  const VertexStars& stars_;
  LargeArray<std::uint32_t> seen_;  ///< per tetrahedron, the search that saw it
  std::uint32_t search_ = 0;
  std::vector<TetId> stack_;
};

}  // namespace tetsculpt
