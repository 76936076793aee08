#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/point.h"

namespace tetsculpt::fuzz {

/// Bytes as points with integer coordinates: the first byte says how far they reach, the others are
/// coordinates. Few values make ties of every kind likely. At most 60 points.
inline std::vector<Point3> small_points(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kMost = 60;
  std::vector<Point3> points;
  if (bytes.empty()) return points;
  const int values = 2 + bytes[0] % 15;
  bytes = bytes.subspan(1);
  for (; bytes.size() >= 3 && points.size() < kMost; bytes = bytes.subspan(3)) {
    const auto at = [&](std::size_t i) { return static_cast<double>(bytes[i] % values); };
    points.push_back({at(0), at(1), at(2)});
  }
  return points;
}

}  // namespace tetsculpt::fuzz
