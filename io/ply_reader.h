#pragma once

#include <filesystem>
#include <string_view>

#include "io/point_file.h"

namespace tetsculpt {

/// The vertices of a PLY file: ascii or binary of either byte order, x, y and z of any type and
/// in any place. Every other scalar of a vertex becomes an attribute of its type; lists do not
/// count. What stands behind the vertices is not looked at.
/// Throws IoError with `path` and the line, or the byte in a binary body.
PointFile parse_ply_points(std::string_view content, const std::filesystem::path& path);

}  // namespace tetsculpt
