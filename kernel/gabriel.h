#pragma once

#include <span>

#include "kernel/edge_order.h"
#include "kernel/point.h"
#include "kernel/tet_complex.h"

/// The Gabriel graph and the extended Gabriel hypergraph: the paper's constraints.
namespace tetsculpt {

/// Which edges are Gabriel edges: no (perturbed) point inside the ball that has the edge as
/// diameter. Only the edge's link can hold one, so this is local. [Gabriel, Sokal 1969] Cost:
/// linear in the complex.
Flags gabriel_edges(std::span<const Point3> points, const TetComplex& complex, int threads = 1);

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
