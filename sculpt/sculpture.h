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
  /// The first labels, from which the solid was made (sculpt_guided only, and only if asked for).
  Flags labels = {};
  /// Vertices that could not be brought to the boundary, in order of id.
  std::vector<VertexId> hidden = {};

  /// Operations done, to hold the complexity argument of the paper's section 3.3 against
  /// (sculpt_paper only). One that was removed alone was popped and not stale, so
  ///   removed.size() == pops - stale + 3 holes.size(), and pops <= pushes.
  struct Work {
    std::size_t looks = 0;   ///< tetrahedra classified by their neighbours: stars turned
    std::size_t pushes = 0;  ///< into the heap of removable tetrahedra
    std::size_t pops = 0;    ///< off that heap
    std::size_t stale = 0;   ///< of them, those that no longer were what they had been pushed as
    std::size_t bases = 0;   ///< boundary triangles where pseudo-prisms were looked for
    std::size_t prisms = 0;  ///< pseudo-prisms pushed into their heap

    friend bool operator==(const Work&, const Work&) = default;
  } work = {};
};

}  // namespace tetsculpt
