#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "kernel/point.h"

namespace tetsculpt {

/// The vertices (lines `v x y z`, what follows does not count) of a Wavefront OBJ text; every
/// other line is skipped. Throws IoError with `path` and the line if one has not three numbers.
std::vector<Point3> parse_obj_points(std::string_view text, const std::filesystem::path& path);

}  // namespace tetsculpt
