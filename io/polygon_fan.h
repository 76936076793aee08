#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kernel/triangle_mesh.h"

namespace tetsculpt {

/// Cuts polygons into triangles while their corners come in: p0 p1 p2 p3 ... becomes the fan
/// (p0, p1, p2), (p0, p2, p3), ... Refers to the triangles, which must outlive it.
class PolygonFan {
 public:
  explicit PolygonFan(std::vector<std::array<std::uint32_t, 3>>& triangles)
      : triangles_(triangles) {}

  void add(std::uint32_t corner) {
    if (corners_ == 0) first_ = corner;
    if (corners_ >= 2) triangles_.push_back({first_, last_, corner});
    last_ = corner;
    ++corners_;
  }

  /// Ends a polygon; what is wrong with it, if anything.
  std::optional<std::string> finish() {
    const std::size_t corners = corners_;
    corners_ = 0;
    if (corners >= 3) return std::nullopt;
    return "a face needs at least 3 corners, this one has " + std::to_string(corners);
  }

 private:
  std::vector<std::array<std::uint32_t, 3>>& triangles_;
  std::uint32_t first_ = 0;
  std::uint32_t last_ = 0;
  std::size_t corners_ = 0;
};

/// For messages: the fault of a face whose corner is no vertex.
inline std::string no_such_vertex(const std::string& index, std::size_t vertices) {
  return "a face names vertex " + index + " of " + std::to_string(vertices);
}

}  // namespace tetsculpt
