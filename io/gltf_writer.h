#pragma once

#include <span>

#include "io/atomic_file.h"
#include "io/attribute.h"
#include "io/write_report.h"
#include "kernel/triangle_mesh.h"

namespace tetsculpt {

enum class GltfContainer {
  kText,    ///< .gltf, all in one JSON text, the buffer as base64
  kBinary,  ///< .glb
};

/// Writes `mesh` as a glTF 2.0 asset of one node, in the axes and units of the points.
///   (1) Coordinates are 32-bit floats, as the format demands, relative to the translation of the
///       node: float_origin() of the points, so that large coordinates keep their digits.
///   (2) Colours are COLOR_0 with the numbers the points have (the format takes them for linear
///       ones), normals NORMAL if all have length one. Any other attribute NAME is _NAME, in its
///       own type up to 16 bits, wider ones as floats; dropped if not all its values are finite.
///   (3) A mesh without triangles is a set of points; without points, an empty asset.
/// Throws IoError if a coordinate is too large, or a .glb file would have 2^32 bytes.
/// [Khronos, glTF 2.0 Specification]
WriteReport write_gltf(const TriangleMesh& mesh, std::span<const Attribute> attributes,
                       GltfContainer container, AtomicFile& out);

}  // namespace tetsculpt
