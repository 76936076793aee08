#pragma once

#include <filesystem>
#include <string_view>

#include "io/point_file.h"

namespace tetsculpt {

/// The vertices of a Wavefront OBJ text, lines `v x y z` that may go on with a weight, which does
/// not count, and a colour: red, green and blue become attributes if every vertex has them.
/// Of other lengths further numbers are scalar_4, ...; see io/point_rows.h. Every other line is
/// skipped. Throws IoError with `path` and the line if a vertex has not three numbers.
PointFile parse_obj_points(std::string_view text, const std::filesystem::path& path);

}  // namespace tetsculpt
