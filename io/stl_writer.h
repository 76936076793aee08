#pragma once

#include <filesystem>

#include "io/atomic_file.h"
#include "kernel/triangle_mesh.h"

namespace tetsculpt {

/// Writes `mesh` as a binary STL file, with outward unit normals (zero for a triangle without
/// area). Coordinates are rounded to 32-bit floats, as the format demands.
/// Throws IoError with `path` if one is too large for that, or if there are 2^32 triangles.
void write_stl(const TriangleMesh& mesh, const std::filesystem::path& path, AtomicFile& out);

}  // namespace tetsculpt
