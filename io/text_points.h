#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "kernel/point.h"

namespace tetsculpt {

/// The points of a text with one point per line: three numbers between blanks, tabs, commas or
/// semicolons; further columns do not count.
///   (1) Blank lines and lines that begin with # or // are skipped.
///   (2) Before the first point there may be one line of column titles (it does not begin with a
///       number) and one line with nothing but the number of points, which then has to be right.
/// Throws IoError with `path` and the line if another line does not begin with three numbers.
std::vector<Point3> parse_text_points(std::string_view text, const std::filesystem::path& path);

}  // namespace tetsculpt
