#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "kernel/point.h"
#include "kernel/triangle_mesh.h"
#include "sculpt/reconstruct.h"

/// What the tests of whole reconstructions share.
namespace tetsculpt::testing {

/// The paper's method, with `threads` threads.
inline Reconstruction reconstruct_paper(std::span<const Point3> points,
                                        Criterion criterion = Criterion::kConstrained,
                                        int threads = 1) {
  ReconstructOptions options;
  options.method = Method::kPaper;
  options.criterion = criterion;
  options.threads = threads;
  return reconstruct(points, options);
}

using Coordinates = std::array<double, 3>;
using OrientedTriangle = std::array<Coordinates, 3>;

/// The oriented triangles by coordinates, each beginning with its least corner, in order;
/// coordinates times `scale`. Adding zero makes 0.0 of -0.0.
inline std::vector<OrientedTriangle> oriented_triangles(const TriangleMesh& mesh,
                                                        double scale = 1) {
  const auto at = [&](std::uint32_t i) {
    const Point3& p = mesh.points[i];
    return Coordinates{p.x * scale + 0.0, p.y * scale + 0.0, p.z * scale + 0.0};
  };
  std::vector<OrientedTriangle> triangles;
  for (const auto& [a, b, c] : mesh.triangles) {
    OrientedTriangle t{at(a), at(b), at(c)};
    std::rotate(t.begin(), std::ranges::min_element(t), t.end());
    triangles.push_back(t);
  }
  std::ranges::sort(triangles);
  return triangles;
}

/// Volume inside, positive if the triangles are counterclockwise from outside.
inline double signed_volume(const TriangleMesh& mesh) {
  const Point3 o = mesh.points.front();
  double six_volumes = 0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Point3 &a = mesh.points[i], &b = mesh.points[j], &c = mesh.points[k];
    const double ux = a.x - o.x, uy = a.y - o.y, uz = a.z - o.z;
    const double vx = b.x - o.x, vy = b.y - o.y, vz = b.z - o.z;
    const double wx = c.x - o.x, wy = c.y - o.y, wz = c.z - o.z;
    six_volumes += ux * (vy * wz - vz * wy) + uy * (vz * wx - vx * wz) + uz * (vx * wy - vy * wx);
  }
  return six_volumes / 6;
}

/// Per point of the mesh, whether a triangle has it.
inline std::vector<bool> points_in_use(const TriangleMesh& mesh) {
  std::vector<bool> used(mesh.points.size(), false);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) used[v] = true;
  }
  return used;
}

}  // namespace tetsculpt::testing
