#pragma once

#include <cstdint>
#include <span>

#include "kernel/large_array.h"
#include "sculpt/label_graph.h"
#include "sculpt/poles.h"

/// A first belief on which side each node lies.
namespace tetsculpt {

enum class Side : std::int8_t { kOutside = -1, kUnknown = 0, kInside = 1 };

/// Spreads labels from infinity, the most certain first: opposite sides for the two poles of a
/// vertex, the same side for nodes whose spheres overlap. One side per node; kUnknown for what no
/// evidence reaches.  [Amenta, Choi, Kolluri 2001]  Cost: linear in the arcs.
LargeArray<Side> first_guess(const LabelGraph& graph, std::span<const PolePair> pairs);

}  // namespace tetsculpt
