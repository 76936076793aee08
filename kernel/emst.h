#pragma once

#include <span>
#include <vector>

#include "kernel/edge_order.h"
#include "kernel/ids.h"
#include "kernel/tet_complex.h"

/// The Euclidean minimum spanning tree and the nearest neighbour graph.
namespace tetsculpt {

/// EMST(P), unique by the order of kernel/edge_order: the edges of the tree, shortest first.
/// `by_length` are edges in that order that contain the tree: all edges of the complex or, since
/// EMST is a subset of the Gabriel graph, only the Gabriel edges. The paper uses Prim's algorithm;
/// Kruskal's finds the same tree.  Cost: nearly linear in `by_length`.
std::vector<EdgeId> emst(const TetComplex& complex, std::span<const EdgeId> by_length);

/// NNG(P): the edges that are the shortest, in that order, at one of their end points; a subset of
/// the EMST. `by_length` as for emst.  Cost: linear.
std::vector<EdgeId> nearest_neighbor_graph(const TetComplex& complex,
                                           std::span<const EdgeId> by_length);

}  // namespace tetsculpt
