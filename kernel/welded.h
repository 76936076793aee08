#pragma once

#include "kernel/triangle_mesh.h"

namespace tetsculpt {

/// `mesh` with the points of one position joined to the first of them, without any tolerance;
/// points and triangles keep their order.
///   (1) -0.0 and 0.0 are one position.   (2) NaNs of equal bits are equal.
/// Precondition: no index is out of range.  Cost: a sort of the points.
TriangleMesh welded(TriangleMesh mesh);

}  // namespace tetsculpt
