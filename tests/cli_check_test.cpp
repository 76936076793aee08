// `tetsculpt check`: what it says of good meshes and of broken ones, and its exit statuses.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/support/check_runs.h"
#include "tests/support/meshes.h"
#include "tests/support/sculpt_cli.h"

namespace tetsculpt {
namespace {

using testing::check;
using testing::cube;
using testing::Run;
using testing::says;
using testing::TempDir;
using Words = std::vector<std::string>;

TEST_CASE("a good mesh") {
  const TempDir dir;
  const Run run = check(dir, cube(-1, 1));
  CHECK(run.status == 0);
  CHECK(run.err.empty());
  CHECK(says(run, "m.off: 12 triangles, 18 edges, 8 vertices\n"));
  CHECK(says(run, "genus 0, volume 8\n"));
  CHECK(says(run, "\nno faults\n"));
  CHECK_FALSE(says(run, "NO"));
}

TEST_CASE("each kind of fault is named and changes the status") {
  const TempDir dir;
  const auto faulty = [&](const TriangleMesh& mesh, const std::string& text) {
    const Run run = check(dir, mesh);
    INFO(run.out);
    CHECK(run.status == 6);
    CHECK(says(run, "fault         " + text));
    CHECK_FALSE(says(run, "no faults"));
  };
  TriangleMesh mesh = cube(-1, 1);
  mesh.triangles.pop_back();
  faulty(mesh, "3 edges with one triangle, in 1 loop; the first joins vertices 1 and 5\n");
  mesh = cube(-1, 1);
  mesh.points.push_back({3, 3, 3});
  faulty(mesh, "1 vertex of no triangle; it is number 8\n");
  mesh.triangles.push_back({0, 3, 8});
  faulty(mesh, "1 edge with more than two triangles; it joins vertices 0 and 3\n");
  mesh = cube(-1, 1);
  mesh.triangles[3] = {7, 4, 6};
  faulty(mesh, "3 edges along which triangles run in the same direction");
  mesh = cube(-1, 1);
  mesh.triangles.push_back(mesh.triangles[5]);
  faulty(mesh, "1 triangle with the corners of an earlier one; it is number 12\n");
  mesh = cube(-1, 1);
  mesh.triangles.push_back({1, 1, 2});
  faulty(mesh, "1 triangle without area; it is number 12\n");
  faulty(testing::inverted(cube(-1, 1)), "1 component facing into the solid; it is number 0\n");
  mesh = testing::with(cube(-1, 1), cube(1, 2));
  faulty(mesh, "1 vertex at the position of an earlier one (--weld joins them); it is number 8\n");
  for (auto& t : mesh.triangles) {
    for (auto& v : t) v = v == 8 ? 7 : v;
  }
  faulty(mesh, "1 vertex whose triangles are not one cycle or fan; it is number 7\n");
  faulty({}, "no triangles\n");
}

TEST_CASE("vertices that are not finite are a fault, not a failure") {
  const TempDir dir;
  dir.file("m.off",
           "OFF 4 4 0\n0 0 0\n1 0 0\n0 1 nan\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  const Run run = testing::run(dir, {"check", "m.off"});
  CHECK(run.status == 6);
  CHECK(says(run, "closed        yes\n"));
  CHECK(says(run, "outward       unknown\n"));
  CHECK(says(run, "1 vertex with a NaN or infinite coordinate; it is number 2\n"));
}

TEST_CASE("weld") {
  const TempDir dir;
  TriangleMesh soup;
  for (const auto& triangle : cube(-1, 1).triangles) {
    TriangleMesh one{{}, {{0, 1, 2}}};
    for (const auto v : triangle) one.points.push_back(cube(-1, 1).points[v]);
    soup = testing::with(soup, one);
  }
  CHECK(check(dir, soup).status == 6);
  const Run run = check(dir, soup, {"--weld"});
  CHECK(run.status == 0);
  CHECK(says(run, "8 vertices (28 joined to others)\n"));
}

TEST_CASE("what cannot be judged has another status") {
  const TempDir dir;
  dir.file("m.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n");
  const Run broken = testing::run(dir, {"check", "m.off"});
  CHECK(broken.status == 2);
  CHECK(broken.out.empty());
  CHECK(broken.err == "tetsculpt: m.off:5: a face names vertex 3 of 3\n");
  CHECK(testing::run(dir, {"check", "none.ply"}).status == 2);
  CHECK(check(dir, cube(-1, 1), {"--points", "none.xyz"}).status == 2);
  dir.file("m.off", "OFF 3 1 0\n0 0 0\n1e300 1e-300 0\n0 1 0\n3 0 1 2\n");
  CHECK(testing::run(dir, {"check", "m.off"}).status == 2);
  for (const Words& words : {Words{"check"}, Words{"check", "a.ply", "b.ply"},
                             Words{"check", "a.ply", "--points"}, Words{"check", "--no"}}) {
    CHECK(testing::run(dir, words).status == 1);
  }
  CHECK(testing::run(dir, {"check", "--help"}).status == 0);
  CHECK(testing::run(dir, {"./check", "out.off"}).status == 2);  // a file of points
}

}  // namespace
}  // namespace tetsculpt
