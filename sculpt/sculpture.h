#pragma once

#include <cstddef>
#include <vector>

#include "kernel/edge_order.h"
#include "kernel/ids.h"

/// What sculpting leaves, whichever method did it.
namespace tetsculpt {

struct Sculpture {
  /// Per tetrahedron of the complex: is it part of the solid?
  Flags solid = {};
  /// The tetrahedra taken off, in order.
  std::vector<TetId> removed = {};
  /// Where in `removed` a pseudo-prism starts: three tetrahedra that went at once and opened a
  /// hole.
  std::vector<std::size_t> holes = {};
  /// Vertices that could not be brought to the boundary, in order of id.
  std::vector<VertexId> hidden = {};
};

}  // namespace tetsculpt
