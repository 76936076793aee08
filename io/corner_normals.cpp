#include "io/corner_normals.h"

#include <cstddef>

#include "io/unit_vectors.h"

namespace tetsculpt {
namespace {

using Triangles = std::span<const std::array<std::uint32_t, 3>>;

constexpr double kCosineOfCrease = 0.7;          // about 45 degrees
constexpr std::size_t kMostTrianglesMixed = 64;  // at a point; the work is quadratic in them

/// The triangles at each point.
class Stars {
 public:
  Stars(std::size_t point_count, Triangles triangles)
      : first_(point_count + 1), triangles_(3 * triangles.size()) {
    for (const auto& corners : triangles) {
      for (const std::uint32_t p : corners) ++first_[p + 1];
    }
    for (std::size_t p = 0; p < point_count; ++p) first_[p + 1] += first_[p];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (const std::uint32_t p : triangles[t]) triangles_[next[p]++] = t;
    }
  }

  std::span<const std::size_t> at(std::uint32_t p) const {
    return std::span(triangles_).subspan(first_[p], first_[p + 1] - first_[p]);
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::size_t> triangles_;
};

}  // namespace

std::vector<std::array<Vec3<double>, 3>> corner_normals(std::span<const Vec3<double>> points,
                                                        Triangles triangles) {
  std::vector<Vec3<double>> areas;  // as long as twice the area, upright on the triangle
  std::vector<Vec3<double>> normals;
  for (const auto& [a, b, c] : triangles) {
    areas.push_back(cross(points[b] - points[a], points[c] - points[a]));
    normals.push_back(unit(areas.back()));
  }
  const Stars stars(points.size(), triangles);
  std::vector<std::array<Vec3<double>, 3>> result(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::span<const std::size_t> star = stars.at(triangles[t][i]);
      Vec3<double> sum = areas[t];
      if (star.size() <= kMostTrianglesMixed) {
        for (const std::size_t other : star) {
          if (other != t && dot(normals[t], normals[other]) > kCosineOfCrease) {
            sum = sum + areas[other];
          }
        }
      }
      result[t][i] = unit(sum);
    }
  }
  return result;
}

}  // namespace tetsculpt
