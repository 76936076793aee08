#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/ids.h"
#include "kernel/large_array.h"
#include "kernel/point.h"
#include "kernel/tet_complex.h"

/// The one total order of edges: by exact length, ties by the ids of their end points.
namespace tetsculpt {

/// One flag per simplex, indexed by its id.
using Flags = LargeArray<std::uint8_t>;

/// The edges whose flag is set, shortest first. Cost: a radix sort; exact comparisons only between
/// edges whose lengths agree to 15 digits.
std::vector<EdgeId> edges_by_length(std::span<const Point3> points, const TetComplex& complex,
                                    const Flags& chosen);

}  // namespace tetsculpt
