#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/vec3.h"

namespace tetsculpt {

/// For each corner of each triangle the unit normal by which it is lit: the mean over the triangles
/// at the point that face nearly the same way, by area, so that surfaces look smooth and creases
/// stay sharp. Zero for a triangle without area.
/// Precondition: coordinates are at most 1, so that nothing overflows.
std::vector<std::array<Vec3<double>, 3>> corner_normals(
    std::span<const Vec3<double>> points, std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace tetsculpt
