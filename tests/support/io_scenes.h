#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "io/image.h"
#include "io/picture.h"
#include "kernel/triangle_mesh.h"

/// What the tests of pictures draw, and how they look at them.
namespace tetsculpt::testing {

/// The cube [-1, 1]^3, its faces outward.
inline TriangleMesh cube() {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.points.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// The unit sphere by `n` circles of latitude and 2 n meridians.
inline TriangleMesh round_sphere(std::uint32_t n) {
  TriangleMesh mesh;
  const std::uint32_t around = 2 * n;
  for (std::uint32_t i = 1; i <= n; ++i) {
    const double polar = std::numbers::pi * i / (n + 1);
    for (std::uint32_t j = 0; j < around; ++j) {
      const double angle = std::numbers::pi * j / n;
      mesh.points.push_back(
          {std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), std::cos(polar)});
    }
  }
  const std::uint32_t top = n * around;
  mesh.points.push_back({0, 0, 1});
  mesh.points.push_back({0, 0, -1});
  for (std::uint32_t j = 0; j < around; ++j) {
    const std::uint32_t next = (j + 1) % around;
    mesh.triangles.push_back({top, j, next});
    mesh.triangles.push_back({top + 1, top - around + next, top - around + j});
    for (std::uint32_t i = 0; i + around < top; i += around) {
      mesh.triangles.push_back({i + j, i + around + j, i + around + next});
      mesh.triangles.push_back({i + j, i + around + next, i + next});
    }
  }
  return mesh;
}

inline TriangleMesh inside_out(TriangleMesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

inline Colour pixel(const Image& image, std::size_t x, std::size_t y) {
  const std::size_t at = 3 * (y * image.width + x);
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

inline Colour middle(const Image& image) { return pixel(image, image.width / 2, image.height / 2); }

inline bool white(const Colour& c) { return c == Colour{255, 255, 255}; }

/// Of the hue in which backs are drawn.
inline bool reddish(const Colour& c) { return c.r > c.g + 20 && c.r > c.b + 20; }

/// How many pixels are such.
template <class Predicate>
std::size_t count_pixels(const Image& image, const Predicate& such) {
  std::size_t n = 0;
  for (std::size_t y = 0; y < image.height; ++y) {
    for (std::size_t x = 0; x < image.width; ++x) n += such(pixel(image, x, y)) ? 1U : 0U;
  }
  return n;
}

}  // namespace tetsculpt::testing
