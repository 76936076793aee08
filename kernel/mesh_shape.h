#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/mesh_report.h"
#include "kernel/sign.h"
#include "kernel/triangle_mesh.h"

/// What the positions of its points make of a mesh.
namespace tetsculpt {

struct ShellShape {
  /// Volume that the shell encloses, positive if it faces away from it; to rounding.
  double volume = 0;
  /// Its sign, exactly; kZero for a shell that is not closed, manifold and oriented.
  Sign facing = Sign::kZero;
  /// How many others are around it: with an odd number it bounds a cavity.
  std::size_t depth = 0;
  /// Faces away from the solid: outward, or into its cavity. Never of a shell that is not closed,
  /// manifold and oriented.
  bool outward = false;
};

struct MeshShape {
  Faults<std::uint32_t> repeated_points;  ///< at the position of an earlier one
  Faults<std::uint32_t> flat_triangles;   ///< corners on one line, or in one place
  /// Closed, manifold and oriented, but not outward.
  Faults<std::uint32_t> inverted_shells;
  std::vector<ShellShape> shells;
  double volume = 0;  ///< of all shells that have one
};

/// Measures `mesh`, of which `report` is judge(mesh). All but the volumes is exact.
/// Throws InvalidPoint and std::length_error as kernel/distinct_points.h.
/// Cost: a sort of the points, and that of kernel/shell_nesting.h.
MeshShape measure(const TriangleMesh& mesh, const MeshReport& report);

/// The points with a coordinate that is NaN or infinite.
Faults<std::uint32_t> invalid_points(std::span<const Point3> points);

}  // namespace tetsculpt
