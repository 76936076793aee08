#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kernel/point.h"

/// Coordinates in formats that hold only 32-bit floats.
namespace tetsculpt {

/// An origin from which coordinates lose least as floats. On each axis: zero if all coordinates are
/// floats, else the middle of the points, rounded to a power of two near their extent so that it is
/// short, most often a float itself, and subtracting it is exact.
Point3 float_origin(std::span<const Point3> points);

/// The first point that is too far from the origin for a float.
std::optional<std::size_t> beyond_floats(std::span<const Point3> points, const Point3& origin = {});

/// The axes ("x", "y", "z") on which a coordinate is not, to the last bit, `origin` plus a float.
std::vector<std::string> rounded_axes(std::span<const Point3> points, const Point3& origin = {});

}  // namespace tetsculpt
