#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "kernel/point.h"

namespace tetsculpt {

/// The vertices of an OFF text (Geomview's object file format), one per line; the faces are not
/// looked at. Before the keyword OFF may stand ST, C and N: their data follow x, y and z.
/// The counts may stand behind the keyword, even without a blank.
/// Throws IoError with `path` and the line on any other header and if a vertex is missing.
std::vector<Point3> parse_off_points(std::string_view text, const std::filesystem::path& path);

}  // namespace tetsculpt
