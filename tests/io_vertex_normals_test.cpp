// Normals at vertices: right on bodies where they are known, whatever the size and triangulation.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "io/vertex_normals.h"
#include "sculpt/reconstruct.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

bool close(const Vec3<double>& a, const Vec3<double>& b, double tolerance = 1e-12) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z) <= tolerance;
}

/// The cube [0, size]^3, each side cut along one of its diagonals: 1, 2 or 3 sides' two triangles
/// meet at a corner.
TriangleMesh cube(double size) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 8; ++i) {
    const auto at = [&](std::uint32_t bit) { return (i & bit) != 0 ? size : 0.0; };
    mesh.points.push_back({at(1), at(2), at(4)});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TEST_CASE("a cube of any size: diagonals, however its sides are cut") {
  const double third = std::sqrt(1.0 / 3);
  for (const double size : {1.0, 1e-300, std::numeric_limits<double>::denorm_min(), 1e300,
                            std::numeric_limits<double>::max()}) {
    CAPTURE(size);
    const TriangleMesh mesh = cube(size);
    const auto normals = vertex_normals(mesh);
    for (std::size_t i = 0; i < 8; ++i) {
      const auto sign = [&](std::size_t bit) { return (i & bit) != 0 ? third : -third; };
      CHECK(close(normals[i], {sign(1), sign(2), sign(4)}));
    }
  }
}

TEST_CASE("coordinates from end to end of the doubles") {
  constexpr double kMost = std::numeric_limits<double>::max();
  const TriangleMesh mesh = {{{-kMost, -kMost, 0}, {kMost, -kMost, 0}, {0, kMost, 0}}, {{0, 1, 2}}};
  for (const Vec3<double>& normal : vertex_normals(mesh)) CHECK(close(normal, {0, 0, 1}));
}

TEST_CASE("a sphere") {
  const auto points = point_sets::sphere(0.1, 7);
  const Reconstruction r = reconstruct(points);
  const auto normals = vertex_normals(r.mesh);
  double sum = 0;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Point3& p = r.mesh.points[i];
    sum += dot(normals[i], {p.x, p.y, p.z});
    CHECK(dot(normals[i], {p.x, p.y, p.z}) > 0.98);
  }
  CHECK(sum > 0.999 * static_cast<double>(normals.size()));
}

TEST_CASE("no triangle, no area, and normals that cancel") {
  TriangleMesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {9, 9, 9}},
                       {{0, 1, 3}, {0, 1, 2}, {0, 2, 1}}};
  const auto normals = vertex_normals(mesh);
  for (const std::size_t i : std::vector<std::size_t>{0, 1, 2}) {
    CHECK(close(normals[i], {0, 0, 1}));  // of the first with an area
  }
  for (const std::size_t i : std::vector<std::size_t>{3, 4}) CHECK(close(normals[i], {0, 0, 0}, 0));
}

TEST_CASE("as attributes") {
  const TriangleMesh mesh = cube(2);
  const std::vector<Attribute> attributes = vertex_normal_attributes(mesh);
  const auto normals = vertex_normals(mesh);
  REQUIRE(attributes.size() == 3);
  CHECK(attributes[0].name == "nx");
  CHECK(attributes[1].name == "ny");
  CHECK(attributes[2].name == "nz");
  for (std::size_t i = 0; i < 8; ++i) {
    CHECK(std::get<std::vector<float>>(attributes[2].values).at(i) ==
          static_cast<float>(normals[i].z));
  }
}

}  // namespace
}  // namespace tetsculpt
