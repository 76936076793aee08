#pragma once

#include <filesystem>
#include <string_view>

#include "io/mesh_file.h"

namespace tetsculpt {

/// The points and polygons of a legacy VTK file with the dataset POLYDATA, ascii or binary; both
/// layouts of POLYGONS, that of version 5.1 with OFFSETS and CONNECTIVITY, too. Vertices, lines and
/// data of points and cells are not looked at; triangle strips are refused.
/// Polygons become fans, see io/polygon_fan.h.
/// Throws IoError with `path` and the line, or the byte in a binary file.
MeshFile parse_vtk_mesh(std::string_view content, const std::filesystem::path& path);

}  // namespace tetsculpt
