#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/ids.h"
#include "kernel/point.h"

/// The order in which points enter the hull.
namespace tetsculpt {

struct SpatialOrder {
  /// All vertices, round after round; within a round along a Hilbert curve.
  std::vector<VertexId> vertices;
  /// Per vertex, its place along one Hilbert curve through all of them.
  std::vector<std::uint32_t> place_on_curve;
  /// Round r is vertices[round_begin[r]] up to vertices[round_begin[r + 1]].
  std::vector<std::size_t> round_begin;
};

/// Biased randomised insertion order: points fall into rounds by pseudo-random coins (a fixed hash
/// of the vertex id), each round about as large as all before it; a round is sorted along a Hilbert
/// curve through the bounding box. Depends on nothing but the points. [Amenta, Choi, Rote 2003]
/// Cost: two radix sorts.
SpatialOrder spatial_order(std::span<const Point3> points);

}  // namespace tetsculpt
