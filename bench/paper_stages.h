#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/egh.h"
#include "kernel/ids.h"
#include "kernel/tet_complex.h"
#include "kernel/triangle_mesh.h"
#include "sculpt/sculpt_paper.h"

/// All that the paper's method computes from a set of points, kept for a look at it, with the time
/// of each stage.
namespace tetsculpt::bench {

enum class Stage { kDelaunay, kEgh, kEmst, kSculpt };
inline constexpr std::array<std::string_view, 4> kStageNames{"Delaunay", "GG, EGH", "EMST",
                                                             "sculpting"};

struct PaperStages {
  DistinctPoints distinct;
  TetComplex complex;
  Flags gabriel;             ///< per edge
  Egh egh;                   ///< edges and triangles
  std::vector<EdgeId> tree;  ///< EMST
  Sculpture sculpture;
  std::vector<std::array<VertexId, 3>> surface;  ///< the triangles that sculpting leaves
  /// Processor seconds by Stage, which do not count what other programs take: distinct points and
  /// their Delaunay complex; Gabriel graph and EGH; edges by length and EMST; sculpting, with the
  /// list of the surface's triangles.
  std::array<double, kStageNames.size()> seconds{};
};

/// Does what reconstruct does for the paper's method, but for the list of the surface's points.
/// Precondition: the points span a solid.
PaperStages paper_stages(std::span<const Point3> points);

/// A triangle over vertices as one of a mesh whose points are all the vertices.
std::array<std::uint32_t, 3> indices(const std::array<VertexId, 3>& corners);

/// The surface when the first `count` tetrahedra were removed. Its points are all vertices.
TriangleMesh surface_after(const PaperStages& stages, std::size_t count);

/// Vertices that stay hidden while the constraints of EMST and EGH hold, and how many tetrahedra
/// had been removed by then.
struct HiddenByConstraints {
  std::vector<VertexId> vertices;
  std::size_t removed = 0;
};
HiddenByConstraints hidden_by_constraints(const PaperStages& stages);

/// Triples of vertices joined by three edges of the EGH, and how many of them are no triangle of
/// the Delaunay complex: the paper's theorem says none.
struct EghCycles {
  std::size_t cycles = 0;
  std::size_t not_in_complex = 0;
};
EghCycles egh_cycles(const PaperStages& stages);

}  // namespace tetsculpt::bench
