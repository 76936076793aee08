#pragma once

#include <span>

#include "io/atomic_file.h"
#include "io/attribute.h"
#include "io/write_report.h"
#include "kernel/triangle_mesh.h"

namespace tetsculpt {

/// Writes `mesh` as an OFF text (Geomview's object file format): COFF with colours, NOFF with
/// normals, CNOFF with both. A vertex is x y z, nx ny nz, red green blue alpha: bytes as they are,
/// from 0 to 255, as most programs have them, other colours as shares of one, with a point or an
/// exponent to tell them apart. The format demands alpha: opaque if there is none.
WriteReport write_off(const TriangleMesh& mesh, std::span<const Attribute> attributes,
                      AtomicFile& out);

}  // namespace tetsculpt
