#pragma once

#include <functional>

#include "kernel/edge_order.h"
#include "kernel/tet_complex.h"
#include "kernel/vertex_stars.h"
#include "sculpt/evidence.h"
#include "sculpt/label_graph.h"
#include "sculpt/star_faults.h"

/// Inside or outside, for each tetrahedron.
namespace tetsculpt {

/// Labels by one minimum cut.
struct CutLabels {
  /// Per tetrahedron: is it believed inside? Infinite ones never are.
  Flags inside;
  /// Where its boundary is no 2-manifold through all vertices.
  StarFaults faults;
};

/// Minimises the evidence's energy over labels of the graph's nodes. The cut is unique.
/// [Labatut, Pons, Keriven 2009 for cuts over a Delaunay complex]
CutLabels cut_labels(const TetComplex& complex, const LabelGraph& graph, const Evidence& evidence);

/// Labels by a series of cuts, per tetrahedron as above.
struct RefinedLabels {
  /// Before any pole insisted.
  Flags first;
  /// Nearest to a surface: few vertices have all their tetrahedra on one side, few stars are bad.
  Flags likely;
  /// The least energy once the poles of vertices that had all their tetrahedra on one side
  /// insisted.
  Flags wanted;
};

/// Cuts again with single tetrahedra as nodes around these faults and where `alone` flags them, and
/// again while poles of hidden vertices insist. `progress` is told before each cut, from 0 to 1,
/// and may throw.
RefinedLabels refined_labels(const TetComplex& complex, const VertexStars& stars, Flags alone,
                             const StarFaults& faults, const Evidence& evidence,
                             const std::function<void(double)>& progress = {});

}  // namespace tetsculpt
