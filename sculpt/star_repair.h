#pragma once

#include "kernel/edge_order.h"
#include "kernel/tet_complex.h"
#include "kernel/vertex_stars.h"
#include "sculpt/evidence.h"

/// Makes the boundary of a set of labels a 2-manifold.
namespace tetsculpt {

/// Makes all stars good (see sculpt/star_inspector.h). Flips labels where stars are not: first
/// where it costs least energy, then, as long as a star is bad, its outside tetrahedra to inside.
/// Always ends with all stars good, because the whole complex is. Cost: linear, plus a constant
/// number of stars per bad one.
void repair_stars(const TetComplex& complex, const VertexStars& stars, const Evidence& evidence,
                  Flags& inside);

}  // namespace tetsculpt
