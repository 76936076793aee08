#pragma once

#include <span>
#include <vector>

#include "kernel/point.h"

namespace tetsculpt {

/// Per point, the distance to the nearest other one, to rounding; infinite if there is no other.
/// Points may span any dimension. Precondition: they are finite and within the domain of
/// kernel/distinct_points.h.  Cost: O(n log n) unless the points are placed against it (a k-d
/// tree).
std::vector<double> nearest_distances(std::span<const Point3> points);

}  // namespace tetsculpt
