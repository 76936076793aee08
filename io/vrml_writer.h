#pragma once

#include <span>

#include "io/atomic_file.h"
#include "io/attribute.h"
#include "io/write_report.h"
#include "kernel/triangle_mesh.h"

namespace tetsculpt {

/// Writes `mesh` as a VRML 2.0 world (VRML97, ISO/IEC 14772-1) with one IndexedFaceSet, with a
/// Color node (shares of one, no alpha) and a Normal node where there are such attributes.
WriteReport write_vrml(const TriangleMesh& mesh, std::span<const Attribute> attributes,
                       AtomicFile& out);

}  // namespace tetsculpt
