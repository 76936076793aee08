#pragma once

#include <cstddef>
#include <vector>

#include "kernel/ids.h"
#include "kernel/large_array.h"

/// The order in which points enter the hull.
namespace tetsculpt {

struct InsertionOrder {
  /// All vertices, round after round; within a round by id, which is along a Hilbert curve.
  LargeArray<VertexId> vertices;
  /// Round r is vertices[round_begin[r]] up to vertices[round_begin[r + 1]].
  std::vector<std::size_t> round_begin;
};

/// Every 8^k-th vertex, for k down to 0, less those before: each round is about seven times as
/// large as all before it, and its vertices are spaced evenly on the curve. Cost: linear.
InsertionOrder insertion_order(std::size_t vertex_count);

}  // namespace tetsculpt
