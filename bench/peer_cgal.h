#pragma once

#include <cstddef>
#include <vector>

#include "kernel/point.h"

namespace tetsculpt::bench {

/// CGAL's Delaunay_triangulation_3, exact predicates, range insert.
std::size_t cgal_tetrahedra(const std::vector<Point3>& points);

}  // namespace tetsculpt::bench
