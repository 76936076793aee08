#pragma once

#include <cstddef>
#include <vector>

#include "kernel/point.h"

namespace tetsculpt::bench {

/// Qhull's delaunay with a point at infinity and joggling off; facets may be merged.
std::size_t qhull_tetrahedra(const std::vector<Point3>& points);

}  // namespace tetsculpt::bench
