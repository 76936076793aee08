#pragma once

#include "io/atomic_file.h"
#include "kernel/triangle_mesh.h"

namespace tetsculpt {

/// Writes `mesh` as a VRML 2.0 world (VRML97, ISO/IEC 14772-1) with one IndexedFaceSet.
void write_vrml(const TriangleMesh& mesh, AtomicFile& out);

}  // namespace tetsculpt
