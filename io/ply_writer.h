#pragma once

#include <span>

#include "io/atomic_file.h"
#include "io/attribute.h"
#include "io/precision.h"
#include "io/write_report.h"
#include "kernel/triangle_mesh.h"

namespace tetsculpt {

enum class PlyEncoding { kBinary, kAscii };

struct PlyOptions {
  PlyEncoding encoding = PlyEncoding::kBinary;
  /// Of x y z. Precondition of kSingle: every coordinate is a float.
  Precision precision = Precision::kDouble;
};

/// Writes `mesh` as a PLY file, binary little endian or ascii: vertices `x y z` and each attribute
/// as a property of its own name and type, faces `list uchar int vertex_indices`. Dropped are
/// attributes whose names no property can have (blanks, x, the name of another).
WriteReport write_ply(const TriangleMesh& mesh, std::span<const Attribute> attributes,
                      const PlyOptions& options, AtomicFile& out);

}  // namespace tetsculpt
