#pragma once

#include <filesystem>
#include <string_view>

#include "io/mesh_file.h"

namespace tetsculpt {

/// The vertices and faces of a PLY file, ascii or binary of either byte order. Faces are the
/// elements `face`, their corners a list `vertex_indices` or `vertex_index` of any type; other
/// elements and properties are not looked at. Polygons become fans, see io/polygon_fan.h.
/// Throws IoError with `path` and the line, or the byte in a binary body, also for a file without
/// faces or with triangle strips.
MeshFile parse_ply_mesh(std::string_view content, const std::filesystem::path& path);

}  // namespace tetsculpt
