#pragma once

#include <cstddef>

#include "kernel/vertex_stars.h"
#include "sculpt/boundary.h"

/// Brings a hidden vertex to the surface by many flips that keep the topology.
namespace tetsculpt {

/// Looks for a sequence of flips near a hidden vertex that ends with it on the boundary and with
/// fewer vertices hidden than before. Every flip keeps the boundary a 2-manifold of the same
/// topology: the basic rules, and their reverse, which hides a vertex for a while. True if it
/// succeeds; else nothing has changed. Cost: at most `steps` times the tetrahedra around the
/// vertex's star.
bool expose_by_walk(Boundary& boundary, const VertexStars& stars, VertexId v, std::size_t steps);

}  // namespace tetsculpt
