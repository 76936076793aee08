#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/triangle_mesh.h"

/// Meshes by hand.
namespace tetsculpt::testing {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Points on a parabola: no two are equal.
inline TriangleMesh mesh_of(Triangles triangles) {
  std::uint32_t n = 0;
  for (const auto& t : triangles) n = std::max({n, t[0] + 1, t[1] + 1, t[2] + 1});
  TriangleMesh mesh{{}, std::move(triangles)};
  for (std::uint32_t i = 0; i < n; ++i) mesh.points.push_back({double(i), double(i * i), 0});
  return mesh;
}

inline Triangles tetrahedron(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  return {{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}};
}

inline Triangles joined(Triangles a, const Triangles& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// m x n squares, both ways around; vertices from `first`.
inline Triangles torus(std::uint32_t m, std::uint32_t n, std::uint32_t first = 0) {
  Triangles triangles;
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return first + i % m * n + j % n; };
  for (std::uint32_t i = 0; i < m; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return triangles;
}

/// The cube [low, high]^3 moved by `x`, facing outward.
inline TriangleMesh cube(double low, double high, double x = 0) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 8; ++i) {
    mesh.points.push_back(
        {x + ((i & 1) != 0 ? high : low), (i & 2) != 0 ? high : low, (i & 4) != 0 ? high : low});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

inline TriangleMesh inverted(TriangleMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// Both, side by side in the lists.
inline TriangleMesh with(TriangleMesh a, const TriangleMesh& b) {
  const auto first = static_cast<std::uint32_t>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const auto& [i, j, k] : b.triangles) {
    a.triangles.push_back({first + i, first + j, first + k});
  }
  return a;
}

}  // namespace tetsculpt::testing
