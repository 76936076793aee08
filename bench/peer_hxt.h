#pragma once

#include <cstddef>
#include <vector>

#include "kernel/point.h"

namespace tetsculpt::bench {

/// The Delaunay tetrahedralization inside Gmsh 4.8 (C. Marot, J. Pellerin, J.-F. Remacle, "One
/// machine, one minute, three billion tetrahedra", 2019), on one thread.
std::size_t hxt_tetrahedra(const std::vector<Point3>& points);

}  // namespace tetsculpt::bench
