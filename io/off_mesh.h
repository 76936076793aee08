#pragma once

#include <filesystem>
#include <string_view>

#include "io/mesh_file.h"

namespace tetsculpt {

/// The vertices and faces of an OFF text, see io/off_reader.h: a line per face with the number of
/// its corners, the corners, counted from 0, and perhaps a colour, which is not looked at.
/// Polygons become fans, see io/polygon_fan.h.
/// Throws IoError with `path` and the line, also for a corner that is no vertex of the file.
MeshFile parse_off_mesh(std::string_view text, const std::filesystem::path& path);

}  // namespace tetsculpt
