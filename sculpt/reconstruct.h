#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/point.h"
#include "kernel/point_graph.h"
#include "kernel/sculpting_record.h"
#include "kernel/tet_mesh.h"
#include "kernel/triangle_mesh.h"
#include "sculpt/priority.h"

/// The whole way from points to a closed surface, in one call.
namespace tetsculpt {

enum class Method {
  kGuided,  ///< by evidence for inside and outside; see sculpt/sculpt_guided.h
  kPaper,   ///< as in Attene, Spagnuolo 2000; see sculpt/sculpt_paper.h
};

/// What to hand out besides the surface. Costs nothing unless asked for.
struct Keep {
  bool graphs = false;
  bool tetrahedra = false;
  bool record = false;
};

struct ReconstructOptions {
  Method method = Method::kGuided;
  /// Order of removal of the paper's method.
  Criterion criterion = Criterion::kConstrained;
  /// Most threads to use, at least 1. The result does not depend on it.
  int threads = 1;
  Keep keep = {};
  /// Told now and then, on the caller's thread, the stage under way ("delaunay", "graphs",
  /// "sculpt") and the share of it that is done, from 0 to 1. May throw: that cancels, and the
  /// exception passes through.
  std::function<void(std::string_view stage, double done)> progress = {};
};

/// What the points span. Only kSolid has a surface.
enum class Span { kNothing, kPoint, kLine, kPlane, kSolid };

struct Reconstruction {
  Span span = Span::kNothing;
  /// The surface. Its points are the distinct input points, bit for bit (of equal ones the first),
  /// in the order of the input. Empty unless span is kSolid.
  TriangleMesh mesh;
  /// Per input point, its index in mesh.points; kHidden if it is not on the surface.
  std::vector<std::uint32_t> vertex_of_input;
  static constexpr std::uint32_t kHidden = 0xffffffffu;
  /// First input index of each distinct point that could not be brought to the surface, ascending.
  std::vector<std::size_t> hidden;

  /// The paper's graphs over mesh.points and, behind them, the hidden points in the order of
  /// `hidden`. Empty unless ReconstructOptions::keep asks for them.
  struct Graphs {
    std::vector<Point3> points;
    PointGraph emst;
    PointGraph gabriel;
    PointGraph egh;  ///< with triangles
  } graphs;
  /// The Delaunay tetrahedra, over the same points. Empty unless asked for.
  TetMesh tetrahedra;
  /// How the surface came about, over the same points. Empty unless asked for.
  SculptingRecord record;

  /// Sizes of what was computed on the way.
  struct Counts {
    std::size_t vertices = 0;  ///< distinct points
    std::size_t tetrahedra = 0;
    std::size_t gabriel_edges = 0;
    std::size_t emst_edges = 0;
    std::size_t egh_edges = 0;
    std::size_t egh_triangles = 0;
    std::size_t holes = 0;  ///< pseudo-prisms removed
  } counts;
  /// Wall-clock seconds per stage.
  struct Seconds {
    double delaunay = 0;
    double graphs = 0;
    double sculpt = 0;
  } seconds;
};

/// Reconstructs a closed 2-manifold through the points. Throws InvalidPoint for a point that is not
/// finite or not within exact range, std::length_error for more points or tetrahedra than 32-bit
/// ids hold. Points that span no solid are no error: see Reconstruction::span. The set of oriented
/// triangles depends on the set of points alone, not on their order.
Reconstruction reconstruct(std::span<const Point3> points, const ReconstructOptions& options = {});

}  // namespace tetsculpt
