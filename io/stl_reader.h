#pragma once

#include <filesystem>
#include <string_view>

#include "io/point_file.h"

namespace tetsculpt {

/// The bytes are those of a binary STL file: as long as the number of triangles in them says.
bool is_binary_stl(std::string_view content);

/// The text begins like an ascii STL file: `solid`, and `facet` or `endsolid` after its line.
/// Binary files may begin with `solid`, too: ask is_binary_stl first.
bool begins_as_ascii_stl(std::string_view content);

/// The corners of the triangles of an STL file, three for each, so that shared ones repeat; kSingle
/// if it is binary. Normals and the two extra bytes of a triangle do not count.
/// Throws IoError with `path` and the line, or the byte in a binary file.
PointFile parse_stl_points(std::string_view content, const std::filesystem::path& path);

}  // namespace tetsculpt
