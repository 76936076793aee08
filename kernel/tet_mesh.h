#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/point.h"

namespace tetsculpt {

/// Tetrahedra as they leave the library.
struct TetMesh {
  std::vector<Point3> points;
  /// Indices into `points`; orient3d of the four corners is kPositive (kernel/predicates.h).
  std::vector<std::array<std::uint32_t, 4>> tetrahedra;
  /// Per tetrahedron: 1 if it is part of the solid, else 0.
  std::vector<std::uint8_t> inside;
};

}  // namespace tetsculpt
