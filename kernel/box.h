#pragma once

#include <algorithm>
#include <span>

#include "kernel/point.h"

namespace tetsculpt {

/// The axis-parallel box of some points.
struct Box {
  Point3 low;
  Point3 high;
  bool empty = true;

  void include(const Point3& p) {
    if (empty) low = high = p;
    empty = false;
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  /// All that is in another.
  void include_all(const Box& other) {
    if (other.empty) return;
    include(other.low);
    include(other.high);
  }
  double longest_side() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
};

/// That of all points, found on up to `threads` threads.
Box box_of(std::span<const Point3> points, int threads = 1);

}  // namespace tetsculpt
