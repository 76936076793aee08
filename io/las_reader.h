#pragma once

#include <filesystem>
#include <string_view>

#include "io/point_file.h"

namespace tetsculpt {

/// The points of an uncompressed LAS file, versions 1.0 to 1.4, point formats 0 to 10.
///   (1) A coordinate is record * scale + offset, both operations rounded to a double.
///   (2) The fields of a record become attributes: intensity return_number number_of_returns
///       scan_direction edge_of_flight_line classification classification_flags scan_angle
///       user_data point_source_id, and where the format has them scanner_channel gps_time red
///       green blue nir. Wave packets and bytes beyond the format do not count.
/// Throws IoError with `path` and the byte; compressed files (LAZ) are refused.
PointFile parse_las_points(std::string_view content, const std::filesystem::path& path);

}  // namespace tetsculpt
