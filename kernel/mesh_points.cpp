#include "kernel/mesh_points.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace tetsculpt {
namespace {

bool has_nan(const Point3& p) { return !(p == p); }

/// Indices into `points`, sorted by position, the first of each position alone.
class PointSet {
 public:
  PointSet(std::span<const Point3> points, std::vector<std::uint32_t> indices)
      : points_(points), indices_(std::move(indices)) {
    std::erase_if(indices_, [&](std::uint32_t i) { return has_nan(points_[i]); });
    std::ranges::sort(indices_, [&](std::uint32_t a, std::uint32_t b) {
      if (points_[a] == points_[b]) return a < b;
      return lexicographically_less(points_[a], points_[b]);
    });
    const auto equal = [&](std::uint32_t a, std::uint32_t b) { return points_[a] == points_[b]; };
    indices_.erase(std::unique(indices_.begin(), indices_.end(), equal), indices_.end());
  }

  std::size_t size() const { return indices_.size(); }

  /// The members that are not in `other`; the first of them is the one of lowest index.
  Faults<std::uint32_t> without(const PointSet& other) const {
    std::vector<std::uint32_t> left;
    auto at = other.indices_.begin();
    for (const std::uint32_t i : indices_) {
      const Point3& p = points_[i];
      while (at != other.indices_.end() && lexicographically_less(other.points_[*at], p)) ++at;
      if (at == other.indices_.end() || other.points_[*at] != p) left.push_back(i);
    }
    if (left.empty()) return {};
    return {left.size(), *std::ranges::min_element(left)};
  }

 private:
  std::span<const Point3> points_;
  std::vector<std::uint32_t> indices_;
};

}  // namespace

PointsOnMesh compare_points(const TriangleMesh& mesh, const MeshReport& report,
                            std::span<const Point3> points) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < points.size(); ++i) all.push_back(i);
  std::vector<std::uint32_t> used;
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    if (report.shell_of_point[v] != MeshReport::kNoShell) used.push_back(v);
  }
  const PointSet input(points, std::move(all));
  const PointSet vertices(mesh.points, std::move(used));
  return {input.size(), input.without(vertices), vertices.without(input)};
}

}  // namespace tetsculpt
