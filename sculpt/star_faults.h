#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "kernel/ids.h"

/// Where the boundary of a set of tetrahedra is no 2-manifold through all vertices.
namespace tetsculpt {

struct StarFaults {
  std::vector<VertexId> hidden;  ///< on no triangle
  std::vector<VertexId> bad;     ///< their triangles are not one single fan
};

/// Finds them from the boundary's oriented triangles, in order of id. A vertex has a single fan
/// exactly if its star is good, see sculpt/star_inspector.h. Cost: linear.
StarFaults star_faults(std::size_t vertex_count,
                       std::span<const std::array<VertexId, 3>> triangles);

}  // namespace tetsculpt
