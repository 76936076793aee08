#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace tetsculpt {

/// A graph over points that are kept elsewhere, or a hypergraph with triangles. Indices of points;
/// the lower one of an edge comes first.
struct PointGraph {
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

}  // namespace tetsculpt
