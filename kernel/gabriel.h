#pragma once

#include <span>

#include "kernel/edge_order.h"
#include "kernel/point.h"
#include "kernel/tet_complex.h"

/// The Gabriel graph.
namespace tetsculpt {

/// Which edges are Gabriel edges: no (perturbed) point inside the ball that has the edge as
/// diameter. Only the edge's link can hold one, so this is local. [Gabriel, Sokal 1969] Cost:
/// linear in the complex.
Flags gabriel_edges(std::span<const Point3> points, const TetComplex& complex, int threads = 1);

}  // namespace tetsculpt
