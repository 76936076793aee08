#pragma once

#include "kernel/edge_order.h"
#include "kernel/tet_complex.h"
#include "kernel/vertex_stars.h"

/// The last resort for stars that are not good.
namespace tetsculpt {

/// Makes all stars good (see sculpt/star_inspector.h) by adding the outside tetrahedra of every bad
/// star to the inside. Always succeeds, because the whole complex has good stars only; but it may
/// go on that far. Cost: linear, plus the stars of what it adds.
void fill_bad_stars(const TetComplex& complex, const VertexStars& stars, Flags& inside);

}  // namespace tetsculpt
