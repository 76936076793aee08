#pragma once

#include <cstdint>
#include <span>

#include "kernel/large_array.h"
#include "kernel/point.h"

/// The order that makes neighbours in space neighbours in memory.
namespace tetsculpt {

/// Indices of the points along a Hilbert curve through a cube around them; points in one of the
/// 2^54 cells of the curve in lexicographic order, equal points by index. The order of distinct
/// points depends on nothing but their set. Coordinates must be in the exact range, see
/// kernel/distinct_points. At most 2^27 points. Cost: one
/// radix sort, and another one of points that agree in the first 37 bits of their cells. On up to
/// `threads` threads.
LargeArray<std::uint32_t> hilbert_order(std::span<const Point3> points, int threads = 1);

}  // namespace tetsculpt
