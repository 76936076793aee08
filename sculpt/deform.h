#pragma once

#include <vector>

#include "kernel/edge_order.h"
#include "kernel/tet_complex.h"
#include "sculpt/boundary.h"
#include "sculpt/circumspheres.h"

/// Moves a surface through the complex without changing its topology: every step adds or takes off
/// one tetrahedron by the paper's basic rules.
namespace tetsculpt {

/// Which tetrahedra go first, by the radius of their circumspheres.
enum class FlipOrder { kSmallestFirst, kLargestFirst };

/// Flips tetrahedra towards `wanted` in that order, as far as the basic rules let it.
/// Cost: a heap of the tetrahedra flipped and their neighbours.
void deform_towards(Boundary& boundary, const Circumspheres& spheres, const Flags& wanted,
                    FlipOrder order);

/// Brings hidden vertices of a 2-manifold to it where a single flip by the basic rules does that,
/// each by the one with the smallest circumsphere, until no more is to be had that way. `hidden`
/// are all the vertices that are not on the boundary of `solid`; returns those that are left.
/// Cost: the stars of the hidden vertices.
std::vector<VertexId> expose_hidden(const TetComplex& complex, const Circumspheres& spheres,
                                    std::vector<VertexId> hidden, Flags& solid);

}  // namespace tetsculpt
