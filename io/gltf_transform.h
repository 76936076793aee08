#pragma once

#include <array>

#include "io/gltf_json.h"
#include "kernel/point.h"

namespace tetsculpt {

/// An affine map: p becomes linear * p + translation.
struct GltfTransform {
  std::array<std::array<double, 3>, 3> linear = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< rows
  Point3 translation = {};

  bool operator==(const GltfTransform&) const = default;

  /// The identity moves nothing, to the last bit, and a mere translation rounds once.
  Point3 operator()(const Point3& p) const;
  /// It turns left into right, and with it counterclockwise into clockwise.
  bool mirrors() const;
};

/// First `inner`, then `outer`.
GltfTransform composed(const GltfTransform& outer, const GltfTransform& inner);

/// What a node says of itself: its matrix, or scale, rotation and translation.
/// Throws IoError on a matrix that is not affine, and a rotation without length.
GltfTransform gltf_transform(const GltfJson& json, const JsonValue& node);

}  // namespace tetsculpt
