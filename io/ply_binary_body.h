#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

#include "io/ply_header.h"
#include "kernel/point.h"

namespace tetsculpt {

/// The vertices of a binary body, which begins at byte `begin` of the file `content`.
/// Throws IoError with `path` and a byte: where elements or the items of a list begin for which are
/// too few bytes, or where the length of a list is negative. Takes no more memory than vertices
/// can be in the file, whatever the header says.
std::vector<Point3> parse_ply_binary_body(const PlyHeader& header, std::string_view content,
                                          std::size_t begin, const std::filesystem::path& path);

}  // namespace tetsculpt
