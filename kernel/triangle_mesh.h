#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kernel/point.h"

/// The surface as it leaves the library: an indexed triangle mesh.
namespace tetsculpt {

struct TriangleMesh {
  std::vector<Point3> points;
  /// Indices into `points`, counterclockwise as seen from outside the solid.
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// What a mesh is, judged from its triangles alone.
struct Topology {
  bool closed = false;           ///< every edge has exactly two triangles
  bool edge_manifold = false;    ///< no edge has more than two
  bool vertex_manifold = false;  ///< the triangles at each vertex form one cycle (one fan if open)
  bool oriented = false;         ///< each directed edge occurs at most once
  std::size_t components = 0;    ///< connected components (by shared vertices)
  std::size_t genus = 0;         ///< summed over components; 0 unless closed, manifold, oriented
};

/// Judges `mesh`; kernel/mesh_report.h tells more. Unused points and triangles with equal corners
/// do not count. Cost: a sort of the half-edges.
Topology topology(const TriangleMesh& mesh);

/// The first thing wrong with `mesh` as an output of this library: an index out of range, a
/// degenerate or duplicate triangle, an open edge, a vertex without one cycle of triangles.
std::optional<std::string> broken_invariant(const TriangleMesh& mesh);

}  // namespace tetsculpt
