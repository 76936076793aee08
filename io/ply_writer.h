#pragma once

#include "io/atomic_file.h"
#include "io/precision.h"
#include "kernel/triangle_mesh.h"

namespace tetsculpt {

/// Writes `mesh` as a binary little endian PLY file: `x y z` of type double, or float for kSingle,
/// and faces `list uchar int vertex_indices`. Precondition of kSingle: every coordinate is a float.
void write_ply(const TriangleMesh& mesh, Precision precision, AtomicFile& out);

}  // namespace tetsculpt
