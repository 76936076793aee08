// compare_points() and welded(): equality of positions, without any tolerance.
#include "kernel/mesh_points.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "kernel/welded.h"
#include "tests/support/meshes.h"

namespace tetsculpt {
namespace {

using testing::cube;

PointsOnMesh compared(const TriangleMesh& mesh, const std::vector<Point3>& points) {
  return compare_points(mesh, judge(mesh), points);
}

TEST_CASE("the vertices are the distinct points") {
  const TriangleMesh mesh = cube(0, 1);
  std::vector<Point3> points = mesh.points;
  points.push_back(points[3]);
  points.push_back({-0.0, 1, -0.0});
  const PointsOnMesh result = compared(mesh, points);
  CHECK(result.distinct == 8);
  CHECK(result.missing.count == 0);
  CHECK(result.invented.count == 0);
}

TEST_CASE("missing and invented, by their first places") {
  TriangleMesh mesh = cube(0, 1);
  const std::vector<Point3> points = mesh.points;
  mesh.points[5].x = std::nextafter(1, 2);
  mesh.points[2].y = std::nextafter(1, 0);
  const PointsOnMesh result = compared(mesh, points);
  CHECK(result.missing.count == 2);
  CHECK(result.missing.first == 2);
  CHECK(result.invented.count == 2);
  CHECK(result.invented.first == 2);
}

TEST_CASE("unused points of the mesh are no vertices") {
  TriangleMesh mesh = cube(0, 1);
  mesh.points.push_back({7, 7, 7});
  std::vector<Point3> points = mesh.points;
  CHECK(compared(mesh, points).missing.first == 8);
  points.pop_back();
  CHECK(compared(mesh, points).invented.count == 0);
}

TEST_CASE("points with a NaN are left out") {
  TriangleMesh mesh = cube(0, 1);
  std::vector<Point3> points = mesh.points;
  points.insert(points.begin(), {std::nan(""), 0, 0});
  mesh.points[1].z = std::nan("");
  const PointsOnMesh result = compared(mesh, points);
  CHECK(result.distinct == 8);
  CHECK(result.missing.count == 1);
  CHECK(result.missing.first == 2);
  CHECK(result.invented.count == 0);
  CHECK(compared({}, {}).distinct == 0);
}

TEST_CASE("welded: equal positions become the first of them") {
  TriangleMesh soup;
  const TriangleMesh whole = cube(0, 1);
  for (const auto& triangle : whole.triangles) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = static_cast<std::uint32_t>(soup.points.size());
      soup.points.push_back(whole.points[triangle[i]]);
    }
    soup.triangles.push_back(corners);
  }
  soup.points[20].x = soup.points[20].x == 0 ? -0.0 : soup.points[20].x;
  const TriangleMesh mesh = welded(soup);
  CHECK(mesh.points.size() == 8);
  CHECK(mesh.points[0] == soup.points[0]);
  CHECK(mesh.triangles[0] == std::array<std::uint32_t, 3>{0, 1, 2});
  CHECK(topology(mesh).closed);
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(mesh.points[mesh.triangles[t][i]] == soup.points[soup.triangles[t][i]]);
    }
  }
  soup.points[4].z = std::nextafter(soup.points[4].z, 2);
  CHECK(welded(soup).points.size() == 9);
}

TEST_CASE("welded: NaNs of equal bits are equal; -0.0 is 0.0") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const TriangleMesh mesh =
      welded({{{nan, 0, 0}, {0, -0.0, 0}, {nan, 0, 0}, {0, 0, -0.0}}, {{0, 1, 2}, {1, 2, 3}}});
  CHECK(mesh.points.size() == 2);
  CHECK(std::signbit(mesh.points[1].y));
  CHECK(mesh.triangles[1] == std::array<std::uint32_t, 3>{1, 0, 1});
}

}  // namespace
}  // namespace tetsculpt
