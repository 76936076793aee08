#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "kernel/point.h"

/// Finds out whether a point set spans space, and where to start if it does.
namespace tetsculpt {

/// Affinely independent points, as many as the set has.
struct FirstSimplex {
  /// Indices of the corners; with four, orient3d of them in this order is kPositive.
  std::array<std::uint32_t, 4> corners{};
  /// 0: no points; 1: one point or all equal; 2: all on a line; 3: all in a plane; 4: a solid.
  int size = 0;
};

/// Scans the points once for a simplex of the highest dimension. Exact.
FirstSimplex first_simplex(std::span<const Point3> points);

}  // namespace tetsculpt
