#pragma once

#include "io/atomic_file.h"
#include "kernel/triangle_mesh.h"

namespace tetsculpt {

/// Writes `mesh` as a Wavefront OBJ text.
void write_obj(const TriangleMesh& mesh, AtomicFile& out);

}  // namespace tetsculpt
