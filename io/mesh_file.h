#pragma once

#include "io/precision.h"
#include "kernel/triangle_mesh.h"

namespace tetsculpt {

/// The mesh of a file, vertices and triangles in their order there.
struct MeshFile {
  TriangleMesh mesh;
  /// kSingle if the file's own type of x, y and z is a 32-bit float; text has kDouble.
  Precision precision = Precision::kDouble;
};

}  // namespace tetsculpt
