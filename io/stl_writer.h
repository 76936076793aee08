#pragma once

#include <span>

#include "io/atomic_file.h"
#include "io/attribute.h"
#include "io/write_report.h"
#include "kernel/triangle_mesh.h"

namespace tetsculpt {

/// Writes `mesh` as a binary STL file, with outward unit normals (zero for a triangle without
/// area). Coordinates are rounded to 32-bit floats, as the format demands.
/// Drops all attributes. Throws IoError if a coordinate is too large for that, or if there are 2^32
/// triangles.
WriteReport write_stl(const TriangleMesh& mesh, std::span<const Attribute> attributes,
                      AtomicFile& out);

}  // namespace tetsculpt
