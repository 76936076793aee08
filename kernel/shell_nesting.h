#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/triangle_mesh.h"

namespace tetsculpt {

/// For each shell of a mesh, how many of the others are around it; that is 0 for shells with
/// `closed` 0, and they are around none. Exact, by the parity of the crossings of a ray.
/// `shell_of_point` is that of kernel/mesh_report.h.
/// Precondition: points are as kernel/predicates.h wants them, and shells do not cross each other.
/// Cost: linear for one shell, else (pairs of shells with nested bounding boxes) x triangles.
std::vector<std::size_t> shell_depths(const TriangleMesh& mesh,
                                      std::span<const std::uint32_t> shell_of_point,
                                      std::span<const std::uint8_t> closed);

}  // namespace tetsculpt
