#pragma once

#include <span>

#include "kernel/edge_order.h"
#include "kernel/point.h"
#include "kernel/tet_complex.h"

/// The extended Gabriel hypergraph: the paper's constraint besides the EMST.
namespace tetsculpt {

/// The extended Gabriel hypergraph EGH(P) = (P, edges, triangles).
struct Egh {
  Flags edges;      ///< Gabriel edges, and those that complete an empty triangle of two of them
  Flags triangles;  ///< triangles of the complex whose three edges are all in `edges`
};

/// EGH(P): where two Gabriel edges share a vertex and the smallest sphere through their three end
/// points is empty, the third edge joins. Such a triangle is in the complex, and only the apexes of
/// its two tetrahedra can lie in its sphere.  [Attene, Spagnuolo 2000, section 3.1] Cost: linear in
/// the complex.
Egh extended_gabriel_hypergraph(std::span<const Point3> points, const TetComplex& complex,
                                const Flags& gabriel);

}  // namespace tetsculpt
