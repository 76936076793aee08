#pragma once

#include <filesystem>
#include <string_view>

#include "io/point_file.h"

namespace tetsculpt {

/// The points of a PCD file (Point Cloud Library), version 0.7: ascii, binary (little endian) and
/// binary_compressed; x, y and z of any type.
///   (1) rgb and rgba, packed into 4 bytes, become red, green, blue and for rgba alpha, all uint8;
///       normal_x becomes nx, see io/column_names.h.
///   (2) Every other field becomes an attribute of its type, one of several numbers name_0, name_1,
///       ...; fields whose name begins with _ are padding.
/// Throws IoError with `path` and the line, or the byte in binary data.
PointFile parse_pcd_points(std::string_view content, const std::filesystem::path& path);

}  // namespace tetsculpt
