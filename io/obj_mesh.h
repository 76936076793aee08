#pragma once

#include <filesystem>
#include <string_view>

#include "io/mesh_file.h"

namespace tetsculpt {

/// The vertices (lines `v`) and faces (lines `f`) of an OBJ text; other lines are not looked at.
/// Of a corner `v/vt/vn` only v counts: from 1, or back from the latest vertex if negative.
/// Polygons become fans, see io/polygon_fan.h.
/// Throws IoError with `path` and the line, also for a corner that is no vertex of the file.
MeshFile parse_obj_mesh(std::string_view text, const std::filesystem::path& path);

}  // namespace tetsculpt
