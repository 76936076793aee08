// --graphs writes three PLY files over the vertices of the surface.
#include <doctest/doctest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "io/read_points.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_cli.h"
#include "tests/support/sculpt_json.h"

namespace tetsculpt {
namespace {

using testing::bytes_of;
using testing::Run;
using testing::TempDir;

/// The size of an element that the header of a PLY file tells; empty if it has none.
std::string element(const std::string& bytes, const std::string& name) {
  const std::size_t at = bytes.find("\nelement " + name + ' ');
  if (at == std::string::npos) return "";
  const std::size_t begin = at + 10 + name.size();
  return bytes.substr(begin, bytes.find('\n', begin) - begin);
}

TEST_CASE("sizes as counted, points as read, bytes as many as the header says") {
  const TempDir dir;
  const std::vector<Point3> points = point_sets::torus(0.2, 1);
  dir.file("a.xyz", testing::xyz(points));
  for (const std::string method : {"guided", "paper"}) {
    const Run run =
        testing::run(dir, {"--method", method, "--graphs", "g", "--stats", "a.xyz", "a.off"});
    REQUIRE(run.status == 0);
    CHECK(testing::names_in(dir) ==
          std::vector<std::string>{"a.off", "a.xyz", "g_egh.ply", "g_emst.ply", "g_gabriel.ply"});
    auto stats = testing::JsonReader(run.out).read();
    for (const std::string name : {"emst", "gabriel", "egh"}) {
      const auto file = dir.path() / ("g_" + name + ".ply");
      const std::string bytes = bytes_of(file);
      CHECK(read_points(file).points == points);
      CHECK(element(bytes, "vertex") == std::to_string(points.size()));
      CHECK(element(bytes, "edge") == stats[name + "_edges"]);
      CHECK(bytes.find("property int vertex1\nproperty int vertex2\n") != std::string::npos);
      const std::string faces = element(bytes, "face");
      CHECK(faces == (name == "egh" ? stats["egh_triangles"] : ""));
      const std::size_t body = bytes.size() - bytes.find("end_header\n") - 11;
      CHECK(body == 24 * points.size() + 8 * std::stoul(stats[name + "_edges"]) +
                        13 * (faces.empty() ? 0 : std::stoul(faces)));
    }
  }
}

TEST_CASE("floats stay floats") {
  const TempDir dir;
  dir.file("a.ply",
           "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
           "property float z\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 0.1\n");
  REQUIRE(testing::run(dir, {"--graphs=g", "a.ply", "b.off"}).status == 0);
  CHECK(bytes_of(dir.path() / "g_emst.ply").find("property float z") != std::string::npos);
  CHECK(read_points(dir.path() / "g_emst.ply").points == read_points(dir.path() / "a.ply").points);
}

TEST_CASE("a place where they can't be made is found before the work") {
  const TempDir dir;
  dir.file("a.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  const Run run = testing::run(dir, {"--graphs=none/g", "a.xyz", "b.off"});
  CHECK(run.status == 5);
  CHECK(run.err.starts_with("tetsculpt: none/g_emst.ply: cannot create: "));
  CHECK(testing::names_in(dir) == std::vector<std::string>{"a.xyz"});
}

}  // namespace
}  // namespace tetsculpt
