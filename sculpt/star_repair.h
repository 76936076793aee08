#pragma once

#include "kernel/edge_order.h"
#include "kernel/tet_complex.h"
#include "kernel/vertex_stars.h"
#include "sculpt/evidence.h"

/// Makes the boundary of a set of labels a 2-manifold.
namespace tetsculpt {

/// A vertex's star is good if its inside tetrahedra are connected through facets within the star, and
/// its outside tetrahedra, infinite ones included, are, too; either may be missing. The boundary of the
/// inside is a 2-manifold exactly if all stars are good. Flips labels where stars are not: first where
/// it costs least energy, then, as long as a star is bad, its outside tetrahedra to inside. Always ends
/// with all stars good, because the whole complex is.
/// Cost: linear, plus a constant number of stars per bad one.
void repair_stars(const TetComplex& complex, const VertexStars& stars, const Evidence& evidence,
                  Flags& inside);

/// Number of parts too many at v: 0 if its star is good.
int star_excess(const TetComplex& complex, const VertexStars& stars, VertexId v,
                const Flags& inside);

}  // namespace tetsculpt
