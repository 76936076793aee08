#pragma once

#include "io/atomic_file.h"
#include "kernel/triangle_mesh.h"

namespace tetsculpt {

/// Writes `mesh` as an OFF text (Geomview's object file format).
void write_off(const TriangleMesh& mesh, AtomicFile& out);

}  // namespace tetsculpt
