// measure(): which way shells face, cavities, flat triangles and repeated points.
#include "kernel/mesh_shape.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "kernel/distinct_points.h"
#include "tests/support/meshes.h"

namespace tetsculpt {
namespace {

using testing::cube;
using testing::inverted;
using testing::with;

MeshShape shape_of(const TriangleMesh& mesh) { return measure(mesh, judge(mesh)); }

TEST_CASE("a cube and its inside out") {
  const MeshShape out = shape_of(cube(-1, 1));
  CHECK(out.volume == doctest::Approx(8));
  CHECK(out.shells[0].outward);
  CHECK(out.shells[0].facing == Sign::kPositive);
  CHECK(out.inverted_shells.count == 0);
  CHECK(out.flat_triangles.count == 0);
  CHECK(out.repeated_points.count == 0);
  const MeshShape in = shape_of(inverted(cube(-1, 1)));
  CHECK(in.volume == doctest::Approx(-8));
  CHECK(in.inverted_shells.count == 1);
  CHECK_FALSE(in.shells[0].outward);
}

TEST_CASE("shells in shells face in turns") {
  const TriangleMesh cavity = with(cube(-4, 4), inverted(cube(-3, 3)));
  const MeshShape good = shape_of(with(cavity, cube(-2, 2)));
  CHECK(good.inverted_shells.count == 0);
  CHECK(good.shells[0].depth == 0);
  CHECK(good.shells[1].depth == 1);
  CHECK(good.shells[2].depth == 2);
  CHECK(good.volume == doctest::Approx(512 - 216 + 64));
  const MeshShape bad = shape_of(with(cavity, inverted(cube(-2, 2))));
  CHECK(bad.inverted_shells.count == 1);
  CHECK(bad.inverted_shells.first == 2);
  CHECK(shape_of(with(cube(-1, 1), inverted(cube(-1, 1, 5)))).inverted_shells.first == 1);
}

// The inner corners lie right above and below corners, edges and diagonals of the outer cube.
TEST_CASE("rays through edges and vertices") {
  for (const double size : {0.25, 0.5, 1.0, 1.5}) {
    const MeshShape inside = shape_of(with(cube(-2, 2), cube(-size, size)));
    CHECK(inside.shells[1].depth == 1);
    CHECK(inside.shells[0].depth == 0);
  }
  // A box in the notch of an L: within its bounding box, not within it.
  TriangleMesh l;
  l.points = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}};
  for (int i = 0; i < 6; ++i) {
    const Point3 p = l.points[static_cast<std::size_t>(i)];
    l.points.push_back({p.x, p.y, 4});
  }
  const std::vector<std::array<std::uint32_t, 3>> floor = {
      {0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 5, 4}};
  for (const auto& [a, b, c] : floor) {
    l.triangles.push_back({a, b, c});
    l.triangles.push_back({a + 6, c + 6, b + 6});
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    l.triangles.push_back({i, j, j + 6});
    l.triangles.push_back({i, j + 6, i + 6});
  }
  REQUIRE(judge(l).closed());
  const MeshShape notch = shape_of(with(l, cube(2, 3)));
  CHECK(notch.shells[0].outward);
  CHECK(notch.shells[1].depth == 0);
  CHECK(shape_of(with(l, cube(0.25, 0.75))).shells[1].depth == 1);
}

TEST_CASE("open shells have no volume and are around nothing") {
  TriangleMesh open = cube(-4, 4);
  open.triangles.pop_back();
  const MeshShape shape = shape_of(with(open, cube(-1, 1)));
  CHECK_FALSE(shape.shells[0].outward);
  CHECK(shape.shells[0].facing == Sign::kZero);
  CHECK(shape.shells[0].volume == 0);
  CHECK(shape.shells[1].outward);
  CHECK(shape.inverted_shells.count == 0);
}

// A tetrahedron that is flat but for one unit in the last place, far from the origin.
TEST_CASE("the sign of a volume is exact") {
  const double far = 1e6;
  const double up = std::nextafter(far, std::numeric_limits<double>::infinity());
  TriangleMesh mesh{{{far, far, far}, {far + 1, far, far}, {far, far + 1, far}, {far, far, up}},
                    testing::tetrahedron(0, 1, 2, 3)};
  CHECK(shape_of(mesh).shells[0].facing == Sign::kPositive);
  CHECK(shape_of(inverted(mesh)).shells[0].facing == Sign::kNegative);
  mesh.points[3] = {far + 1, far + 1, far};
  const MeshShape flat = shape_of(mesh);
  CHECK(flat.shells[0].facing == Sign::kZero);
  CHECK(flat.inverted_shells.count == 1);
  CHECK(flat.flat_triangles.count == 0);
  // Three planes of thirds: rounded products do not cancel, exact ones do.
  const double t = 1.0 / 3;
  mesh.points = {{t, t, t}, {2 * t, t, 3 * t}, {t, 5 * t, -3 * t}, {7 * t, t, t}};
  for (Point3& p : mesh.points) p.z = p.x + p.y;
  const Sign facing = shape_of(mesh).shells[0].facing;
  CHECK(shape_of(inverted(mesh)).shells[0].facing == -facing);
}

TEST_CASE("flat triangles and repeated points") {
  TriangleMesh mesh = cube(-1, 1);
  mesh.points.push_back({-1, -1, -1});
  mesh.points.push_back({0, -1, -1});
  mesh.triangles.push_back({0, 9, 1});  // on one line
  mesh.triangles.push_back({0, 8, 3});  // two corners in one place
  const MeshShape shape = shape_of(mesh);
  CHECK(shape.flat_triangles.count == 2);
  CHECK(shape.flat_triangles.first == 12);
  CHECK(shape.repeated_points.count == 1);
  CHECK(shape.repeated_points.first == 8);
}

TEST_CASE("any scale; what exact arithmetic cannot hold is refused") {
  for (const double scale : {0x1p-340, 0x1p300}) {
    TriangleMesh mesh = cube(-scale, scale);
    CHECK(shape_of(mesh).shells[0].outward);
    CHECK(shape_of(inverted(mesh)).inverted_shells.count == 1);
  }
  TriangleMesh wide = cube(-1, 1);
  wide.points[0].x = 1e-300;
  CHECK_THROWS_AS(shape_of(wide), InvalidPoint);
  wide.points[0].x = std::nan("");
  CHECK(invalid_points(wide.points).count == 1);
}

}  // namespace
}  // namespace tetsculpt
