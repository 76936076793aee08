#pragma once

#include "kernel/edge_order.h"
#include "kernel/vertex_stars.h"
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

/// Brings hidden vertices to the surface: where a single flip does it, by the one with the smallest
/// circumsphere; else by the shortest sequence of flips nearby that ends with it, up to three.
/// Searches a bounded number of sequences per vertex.
void expose_hidden(Boundary& boundary, const VertexStars& stars, const Circumspheres& spheres);

}  // namespace tetsculpt
