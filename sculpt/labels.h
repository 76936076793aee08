#pragma once

#include "kernel/edge_order.h"
#include "kernel/tet_complex.h"
#include "kernel/vertex_stars.h"
#include "sculpt/evidence.h"

/// Inside or outside, for each tetrahedron.
namespace tetsculpt {

/// Flags per tetrahedron: is it believed inside? Infinite ones never are.
struct Labels {
  /// Nearest to a surface: few vertices have all their tetrahedra on one side, few stars are bad.
  Flags likely;
  /// The least energy once the poles of vertices that had all their tetrahedra on one side
  /// insisted.
  Flags wanted;
};

/// Minimises the evidence's energy by minimum cuts. Changes `evidence.inside_bias` where poles
/// insist. [Labatut, Pons, Keriven 2009 for cuts over a Delaunay complex]
Labels cut_labels(const TetComplex& complex, const VertexStars& stars, Evidence& evidence);

}  // namespace tetsculpt
