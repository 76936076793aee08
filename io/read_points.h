#pragma once

#include <filesystem>

#include "io/point_file.h"

namespace tetsculpt {

/// Reads the points of a file; its extension, in either case, names the format:
/// .xyz .txt .csv .pts .asc (text, see io/text_points.h), .ply, .obj, .off.
///   (1) Every value is the nearest double to what the file says, and -0.0 stays -0.0.
///   (2) NaN and infinite coordinates, and no points at all, are passed on, not refused.
/// Throws IoError on an unknown extension, a file that cannot be read, or a broken one.
/// Cost: linear; the file is in memory while it is read.
PointFile read_points(const std::filesystem::path& path);

}  // namespace tetsculpt
