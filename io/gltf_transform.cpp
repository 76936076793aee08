// "glTF 2.0 Specification" (Khronos Group 2021), section 3.5.3 (transformations).
#include "io/gltf_transform.h"

#include <cstddef>

namespace tetsculpt {
namespace {

using Rows = std::array<std::array<double, 3>, 3>;

constexpr Rows kIdentity = GltfTransform().linear;

/// Of a quaternion x y z w of any length but zero.
Rows rotation(const std::array<double, 4>& q) {
  const auto& [x, y, z, w] = q;
  const double s = 2 / (x * x + y * y + z * z + w * w);
  return {{{1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)},
           {s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w)},
           {s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)}}};
}

double sum(double a, double b) { return b == 0 ? a : a + b; }  // -0.0 + 0 would be 0

Point3 times(const Rows& m, const Point3& p) {
  return {m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z,
          m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z,
          m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z};
}

}  // namespace

Point3 GltfTransform::operator()(const Point3& p) const {
  const Point3 turned = linear == kIdentity ? p : times(linear, p);
  return {sum(turned.x, translation.x), sum(turned.y, translation.y), sum(turned.z, translation.z)};
}

bool GltfTransform::mirrors() const {
  const auto& [a, b, c] = linear;
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
             a[2] * (b[0] * c[1] - b[1] * c[0]) <
         0;
}

GltfTransform composed(const GltfTransform& outer, const GltfTransform& inner) {
  GltfTransform result{.linear = inner.linear, .translation = outer(inner.translation)};
  if (outer.linear == kIdentity) return result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      result.linear[i][k] = outer.linear[i][0] * inner.linear[0][k] +
                            outer.linear[i][1] * inner.linear[1][k] +
                            outer.linear[i][2] * inner.linear[2][k];
    }
  }
  return result;
}

GltfTransform gltf_transform(const GltfJson& json, const JsonValue& node) {
  GltfTransform result;
  if (const auto m = json.numbers_if_any<16>(node, "matrix")) {  // columns
    const std::array<double, 16>& at = *m;
    if (at[3] != 0 || at[7] != 0 || at[11] != 0 || at[15] != 1) {
      json.fail(*node.member("matrix"), "a matrix whose last row is not 0 0 0 1");
    }
    for (std::size_t i = 0; i < 3; ++i) result.linear[i] = {at[i], at[i + 4], at[i + 8]};
    result.translation = {at[12], at[13], at[14]};
    return result;
  }
  if (const auto q = json.numbers_if_any<4>(node, "rotation")) {
    if (*q == std::array<double, 4>{}) json.fail(*node.member("rotation"), "a rotation of zeros");
    if ((*q)[0] != 0 || (*q)[1] != 0 || (*q)[2] != 0) result.linear = rotation(*q);
  }
  if (const auto s = json.numbers_if_any<3>(node, "scale")) {
    for (auto& row : result.linear) {
      for (std::size_t k = 0; k < 3; ++k) row[k] *= (*s)[k];
    }
  }
  if (const auto t = json.numbers_if_any<3>(node, "translation")) {
    result.translation = {(*t)[0], (*t)[1], (*t)[2]};
  }
  return result;
}

}  // namespace tetsculpt
