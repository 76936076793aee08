#pragma once

#include "kernel/edge_order.h"
#include "kernel/vertex_stars.h"
#include "sculpt/boundary.h"
#include "sculpt/evidence.h"

/// Moves a surface through the complex without changing its topology: every step adds or takes off one
/// tetrahedron by the paper's basic rules.
namespace tetsculpt {

/// Flips tetrahedra towards `wanted`, cheapest first, as far as the basic rules let it.
void deform_towards(Boundary& boundary, const Evidence& evidence, const Flags& wanted);

/// Brings hidden vertices to the surface: where a single flip does it, the cheapest; else by the
/// shortest sequence of flips nearby that ends with it, up to four.
void expose_hidden(Boundary& boundary, const VertexStars& stars, const Evidence& evidence);

}  // namespace tetsculpt
