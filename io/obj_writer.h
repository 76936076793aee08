#pragma once

#include <span>

#include "io/atomic_file.h"
#include "io/attribute.h"
#include "io/write_report.h"
#include "kernel/triangle_mesh.h"

namespace tetsculpt {

/// Writes `mesh` as a Wavefront OBJ text. Colours follow the coordinates of their vertex as shares
/// of one, without alpha, as many programs have them; normals are `vn`, one per vertex.
WriteReport write_obj(const TriangleMesh& mesh, std::span<const Attribute> attributes,
                      AtomicFile& out);

}  // namespace tetsculpt
