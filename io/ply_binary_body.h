#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "io/ply_header.h"
#include "io/point_file.h"

namespace tetsculpt {

/// The vertices of a binary body, which begins at byte `begin` of the file `content`, with their
/// other scalars as attributes.
/// Throws IoError with `path` and a byte: where elements or the items of a list begin for which are
/// too few bytes, or where the length of a list is negative. Takes no more memory than vertices
/// can be in the file, whatever the header says.
PointFile parse_ply_binary_body(const PlyHeader& header, std::string_view content,
                                std::size_t begin, const std::filesystem::path& path);

}  // namespace tetsculpt
