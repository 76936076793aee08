// A point is inside a shell if the ray upwards from it crosses an odd number of its triangles. The
// ray is thought to be moved a little, by a positive infinitesimal in y and then by a smaller one
// in -x: an edge that it meets in projection lies then on one side of it for both its triangles.
#include "kernel/shell_nesting.h"

#include <algorithm>
#include <array>
#include <optional>

#include "kernel/box.h"
#include "kernel/predicates.h"

namespace tetsculpt {
namespace {

/// kPositive if p lies to the left of the way from a to b, seen from above.
Sign side_from_above(const Point3& a, const Point3& b, const Point3& p) {
  return orient3d({a.x, a.y, 0}, {b.x, b.y, 0}, {p.x, p.y, 0}, {p.x, p.y, -1});
}

/// The moved ray, projected: whether it meets the triangle's projection.
bool under_or_over(const Point3& p, const std::array<Point3, 3>& corners) {
  bool inside = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point3* low = &corners[i];
    const Point3* high = &corners[(i + 1) % 3];
    if ((low->y > p.y) == (high->y > p.y)) continue;
    if (low->y > high->y) std::swap(low, high);
    if (side_from_above(*low, *high, p) == Sign::kPositive) inside = !inside;
  }
  return inside;
}

bool contains(const Box& outer, const Box& b) {
  return outer.low.x <= b.low.x && outer.low.y <= b.low.y && outer.low.z <= b.low.z &&
         b.high.x <= outer.high.x && b.high.y <= outer.high.y && b.high.z <= outer.high.z;
}

/// Shells as ranges of points and of triangles.
class Nesting {
 public:
  Nesting(const TriangleMesh& mesh, std::span<const std::uint32_t> shell_of_point,
          std::span<const std::uint8_t> closed)
      : mesh_(mesh),
        closed_(closed),
        boxes_(closed.size()),
        points_(closed.size()),
        triangles_(closed.size()) {
    for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
      const std::uint32_t shell = shell_of_point[v];
      if (shell >= closed.size() || closed[shell] == 0) continue;
      boxes_[shell].include(mesh.points[v]);
      points_[shell].push_back(v);
    }
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const std::uint32_t shell = shell_of_point[mesh.triangles[t][0]];
      if (shell < closed.size() && closed[shell] != 0) triangles_[shell].push_back(t);
    }
  }

  std::size_t depth(std::size_t shell) const {
    std::size_t around = 0;
    for (std::size_t other = 0; other < closed_.size(); ++other) {
      if (other == shell || closed_[shell] == 0 || closed_[other] == 0) continue;
      around += contains(boxes_[other], boxes_[shell]) && inside(shell, other);
    }
    return around;
  }

 private:
  // By the first of the shell's points that is not on the other one.
  bool inside(std::size_t shell, std::size_t other) const {
    for (const std::uint32_t v : points_[shell]) {
      if (const auto is_inside = inside(mesh_.points[v], other)) return *is_inside;
    }
    return false;
  }

  // Nothing if the point is on the shell.
  std::optional<bool> inside(const Point3& p, std::size_t shell) const {
    bool odd = false;
    for (const std::uint32_t t : triangles_[shell]) {
      const auto& [a, b, c] = mesh_.triangles[t];
      const std::array<Point3, 3> corners{mesh_.points[a], mesh_.points[b], mesh_.points[c]};
      if (std::max({corners[0].z, corners[1].z, corners[2].z}) < p.z) continue;
      if (!under_or_over(p, corners)) continue;
      const Sign seen = side_from_above(corners[0], corners[1], corners[2]);
      const Sign below = orient3d(corners[0], corners[1], corners[2], p);
      if (below == Sign::kZero) return std::nullopt;
      odd = odd != (below == seen);
    }
    return odd;
  }

  const TriangleMesh& mesh_;
  std::span<const std::uint8_t> closed_;
  std::vector<Box> boxes_;
  std::vector<std::vector<std::uint32_t>> points_;
  std::vector<std::vector<std::uint32_t>> triangles_;
};

}  // namespace

std::vector<std::size_t> shell_depths(const TriangleMesh& mesh,
                                      std::span<const std::uint32_t> shell_of_point,
                                      std::span<const std::uint8_t> closed) {
  std::vector<std::size_t> depths(closed.size(), 0);
  if (closed.size() < 2) return depths;
  const Nesting nesting(mesh, shell_of_point, closed);
  for (std::size_t shell = 0; shell < closed.size(); ++shell) depths[shell] = nesting.depth(shell);
  return depths;
}

}  // namespace tetsculpt
