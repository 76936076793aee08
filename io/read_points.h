#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "io/point_file.h"
#include "io/point_format.h"

namespace tetsculpt {

struct ReadPointsOptions {
  /// Empty: the content names it if it bears the mark of a format, else the extension of the path,
  /// in either case, else what the content looks like.
  std::optional<PointFormat> format = {};
};

/// Reads the points of a file and their attributes: .xyz .txt .csv .pts .asc (text, see
/// io/text_points.h), .ply, .obj, .off, .stl, .pcd, .las, .vtk (see the reader of each).
///   (1) Every value is the nearest double to what the file says, and -0.0 stays -0.0.
///   (2) NaN and infinite coordinates, and no points at all, are passed on, not refused.
///   (3) The names of attributes are distinct, without blanks, and none is x, y or z.
/// Throws IoError on an unknown format, a file that cannot be read, or a broken one; compressed
/// files are refused. Memory: the file while it is read, and no more than in proportion to it,
/// whatever its counts say. Cost: linear.
PointFile read_points(const std::filesystem::path& path, const ReadPointsOptions& options = {});

/// As read_points, from the bytes of a file; `path` is for messages, and for its extension.
PointFile parse_points(std::string_view content, const std::filesystem::path& path,
                       const ReadPointsOptions& options = {});

}  // namespace tetsculpt
