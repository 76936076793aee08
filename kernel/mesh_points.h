#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "kernel/mesh_report.h"
#include "kernel/point.h"
#include "kernel/triangle_mesh.h"

namespace tetsculpt {

/// How the vertices of a mesh and a set of points go together.
struct PointsOnMesh {
  std::size_t distinct = 0;        ///< of the points
  Faults<std::uint32_t> missing;   ///< distinct points that are no vertex: their first indices
  Faults<std::uint32_t> invented;  ///< vertices that are no point of the set
};

/// Compares the used points of `mesh`, of which `report` is judge(mesh), with `points` by equality,
/// without any tolerance; -0.0 equals 0.0. Points of either with a NaN are left out.
/// Cost: a sort of both.
PointsOnMesh compare_points(const TriangleMesh& mesh, const MeshReport& report,
                            std::span<const Point3> points);

}  // namespace tetsculpt
