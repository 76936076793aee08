#include "io/vertex_normals.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "io/unit_vectors.h"

namespace tetsculpt {
namespace {

double length(const Vec3<double>& v) { return std::hypot(v.x, v.y, v.z); }

// What is left of a sum of unit vectors, none of them longer than pi, that is nothing but rounding.
constexpr double kCancelled = 1e-12;

std::array<double, 3> angles(const Point3& a, const Point3& b, const Point3& c) {
  const Vec3<double> ab = direction(a, b);
  const Vec3<double> bc = direction(b, c);
  const Vec3<double> ca = direction(c, a);
  const auto between = [](const Vec3<double>& u, const Vec3<double>& v) {
    return std::atan2(length(cross(u, v)), -dot(u, v));
  };
  return {between(ca, ab), between(ab, bc), between(bc, ca)};
}

}  // namespace

std::vector<Vec3<double>> vertex_normals(const TriangleMesh& mesh) {
  constexpr Vec3<double> kNone = {0, 0, 0};
  std::vector<Vec3<double>> sums(mesh.points.size(), kNone);
  std::vector<Vec3<double>> first(mesh.points.size(), kNone);
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point3& pa = mesh.points[a];
    const Point3& pb = mesh.points[b];
    const Point3& pc = mesh.points[c];
    const Vec3<double> normal = unit_normal(pa, pb, pc);
    if (length(normal) == 0) continue;
    const std::array<double, 3> weights = angles(pa, pb, pc);
    const std::array<std::uint32_t, 3> corners = {a, b, c};
    for (std::size_t k = 0; k < 3; ++k) {
      sums[corners[k]] = sums[corners[k]] + normal * weights[k];
      if (length(first[corners[k]]) == 0) first[corners[k]] = normal;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    sums[i] = length(sums[i]) > kCancelled ? unit(sums[i]) : first[i];
  }
  return sums;
}

std::vector<Attribute> vertex_normal_attributes(const TriangleMesh& mesh) {
  std::vector<float> x;
  std::vector<float> y;
  std::vector<float> z;
  for (const Vec3<double>& normal : vertex_normals(mesh)) {
    x.push_back(static_cast<float>(normal.x));
    y.push_back(static_cast<float>(normal.y));
    z.push_back(static_cast<float>(normal.z));
  }
  return {{"nx", std::move(x)}, {"ny", std::move(y)}, {"nz", std::move(z)}};
}

}  // namespace tetsculpt
