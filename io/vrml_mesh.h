#pragma once

#include <filesystem>
#include <string_view>

#include "io/mesh_file.h"

namespace tetsculpt {

/// The face sets of a VRML 2.0 text (VRML97): `point`, `coordIndex` and `ccw` of each
/// IndexedFaceSet; several become one mesh. Polygons become fans, see io/polygon_fan.h.
/// Throws IoError with `path` and the line, also for what would change the mesh but is not read:
/// other geometry, Transforms that move something, instances (USE) of geometry, Inline and PROTO.
MeshFile parse_vrml_mesh(std::string_view text, const std::filesystem::path& path);

}  // namespace tetsculpt
