#pragma once

#include <cstdint>
#include <vector>

#include "kernel/point.h"

/// A body with a concave crease whose surface is known exactly: two unit balls, 1.4 apart.
namespace tetsculpt::bench {

/// Points on it, at least `spacing` apart but at the crease.
std::vector<Point3> dumbbell(double spacing, std::uint64_t seed);
/// Distance of a point from the surface.
double distance_to_dumbbell(const Point3& p);
double dumbbell_area();

}  // namespace tetsculpt::bench
