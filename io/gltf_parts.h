#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "io/attribute.h"
#include "io/gltf_codes.h"
#include "io/number_columns.h"
#include "io/write_report.h"
#include "kernel/point.h"
#include "kernel/triangle_mesh.h"

/// A mesh as the accessors of a glTF 2.0 asset.
namespace tetsculpt {

/// One accessor with its own buffer view. It holds references to what it was made of.
struct GltfPart {
  std::string semantic;    ///< of an attribute of vertices; empty for the indices
  std::size_t count = 0;   ///< of elements
  std::size_t stride = 0;  ///< bytes from element to element, a multiple of 4
  std::size_t components = 1;
  GltfType type = GltfType::kFloat32;
  bool normalized = false;
  std::string bounds = {};  ///< members "min" and "max", if any
  /// Puts these elements at `to`, whose bytes are zero.
  std::function<void(RowRange, char* to)> store = {};

  std::size_t size() const { return count * stride; }
};

/// The parts of `mesh`, none if it has no points; coordinates are taken relative to `origin`. Lists
/// in `report` what is rounded, coordinates apart, and dropped. Precondition: offsets from the
/// origin fit floats.
std::vector<GltfPart> gltf_parts(const TriangleMesh& mesh, const Point3& origin,
                                 std::span<const Attribute> attributes, WriteReport& report);

}  // namespace tetsculpt
