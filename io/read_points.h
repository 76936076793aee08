#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "io/point_file.h"
#include "io/point_format.h"

namespace tetsculpt {

struct ReadPointsOptions {
  /// Empty: the extension of the path names it, in either case.
  std::optional<PointFormat> format = {};
};

/// Reads the points of a file: .xyz .txt .csv .pts .asc (text, see io/text_points.h), .ply, .obj,
/// .off.
///   (1) Every value is the nearest double to what the file says, and -0.0 stays -0.0.
///   (2) NaN and infinite coordinates, and no points at all, are passed on, not refused.
/// Throws IoError on an unknown extension, a file that cannot be read, or a broken one.
/// Cost: linear; the file is in memory while it is read.
PointFile read_points(const std::filesystem::path& path, const ReadPointsOptions& options = {});

/// As read_points, from the bytes of a file; `path` is for messages, and for the format if the
/// options name none.
PointFile parse_points(std::string_view content, const std::filesystem::path& path,
                       const ReadPointsOptions& options = {});

}  // namespace tetsculpt
