#pragma once

#include <filesystem>
#include <string_view>

#include "io/mesh_file.h"

namespace tetsculpt {

/// The triangles of an STL file, binary or text. A file is binary if its length is that of the
/// triangles it announces, else text if it begins with `solid`; several solids are one mesh.
/// Corners of one position are one vertex, without any tolerance (see kernel/welded.h): the first
/// in the file. Normals are not looked at; a loop of more than three corners becomes a fan.
/// Throws IoError with `path` and the line or byte.
MeshFile parse_stl_mesh(std::string_view content, const std::filesystem::path& path);

}  // namespace tetsculpt
