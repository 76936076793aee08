#pragma once

#include <cstdint>
#include <span>

#include "kernel/edge_order.h"
#include "kernel/point_graph.h"
#include "kernel/tet_complex.h"
#include "kernel/tet_mesh.h"

/// What is handed out besides the surface. `index` numbers the vertices of the complex anew.
namespace tetsculpt {

/// The edges that are flagged, in the order of their ids.
PointGraph kept_edges(const TetComplex& complex, const Flags& edges,
                      std::span<const std::uint32_t> index);

/// Flagged edges and triangles.
PointGraph kept_hypergraph(const TetComplex& complex, const Flags& edges, const Flags& triangles,
                           std::span<const std::uint32_t> index);

/// The finite tetrahedra, without points.
TetMesh kept_tetrahedra(const TetComplex& complex, const Flags& solid,
                        std::span<const std::uint32_t> index);

}  // namespace tetsculpt
