#pragma once

#include <cstddef>
#include <vector>

#include "kernel/point.h"

namespace tetsculpt::bench {

/// TetGen's tetrahedralize, Delaunay only.
std::size_t tetgen_tetrahedra(const std::vector<Point3>& points);

}  // namespace tetsculpt::bench
