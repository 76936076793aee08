// --stats prints one JSON object with the documented members, true to what was made; --quiet is
// silent.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tests/support/point_sets.h"
#include "tests/support/sculpt_cli.h"
#include "tests/support/sculpt_json.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

using testing::JsonReader;
using testing::Run;
using testing::TempDir;
using Members = testing::JsonMembers;

Run run_stats(const TempDir& dir, const std::vector<Point3>& points,
              std::vector<std::string> more = {}) {
  dir.file("points.xyz", testing::xyz(points));
  more.insert(more.end(), {"--method", "paper", "--stats", "points.xyz", "surface.off"});
  return testing::run(dir, more);
}

TEST_CASE("exactly the documented members, on one line") {
  const TempDir dir;
  const Run run = run_stats(dir, point_sets::torus(0.2, 1), {"--threads", "2"});
  CHECK(run.status == 0);
  CHECK(std::ranges::count(run.out, '\n') == 1);
  CHECK(run.out.ends_with("}\n"));
  std::set<std::string> names;
  for (const auto& [name, value] : JsonReader(run.out).read()) names.insert(name);
  CHECK(names == std::set<std::string>{
                     "version",        "holes",         "points",           "skipped",
                     "duplicates",     "vertices",      "tetrahedra",       "emst_edges",
                     "gabriel_edges",  "egh_edges",     "egh_triangles",    "triangles",
                     "components",     "genus",         "closed",           "manifold",
                     "hidden",         "method",        "criterion",        "threads",
                     "seconds",        "seconds.read",  "seconds.delaunay", "seconds.graphs",
                     "seconds.sculpt", "seconds.write", "seconds.total"});
}

TEST_CASE("the numbers are those of the surface") {
  const TempDir dir;
  std::vector<Point3> points = point_sets::torus(0.15, 1);
  const std::size_t n = points.size();
  points = point_sets::joined(points, {points[3], points[3], points[7]});
  points.push_back({0, 0, std::nan("")});
  const Run run = run_stats(dir, points, {"--skip-invalid", "--threads=3"});
  REQUIRE(run.status == 0);
  Members stats = JsonReader(run.out).read();
  const TriangleMesh mesh = testing::mesh_of_off(dir.path() / "surface.off");
  const Topology t = topology(mesh);
  CHECK(stats["points"] == std::to_string(n + 4));
  CHECK(stats["skipped"] == "1");
  CHECK(stats["duplicates"] == "3");
  CHECK(stats["vertices"] == std::to_string(n));
  CHECK(stats["emst_edges"] == std::to_string(n - 1));
  CHECK(stats["triangles"] == std::to_string(mesh.triangles.size()));
  CHECK(stats["genus"] == std::to_string(t.genus));
  CHECK(stats["components"] == "1");
  CHECK(stats["closed"] == "true");
  CHECK(stats["manifold"] == "true");
  CHECK(stats["hidden"] == "0");
  CHECK(stats["method"] == "\"paper\"");
  CHECK(stats["criterion"] == "\"constrained\"");
  CHECK(stats["threads"] == "3");
  for (const std::string stage : {"read", "delaunay", "graphs", "sculpt", "write"}) {
    INFO(stage);
    const double seconds = std::stod(stats["seconds." + stage]);
    CHECK(seconds >= 0);
    CHECK(seconds <= std::stod(stats["seconds.total"]) + 1e-6);
  }
}

TEST_CASE("every criterion by its name; hidden points are counted") {
  const TempDir dir;
  for (const std::string criterion : {"constrained", "longest", "area", "gamma"}) {
    const Run run = run_stats(dir, point_sets::uniform_cube(40, 2), {"--criterion", criterion});
    CHECK(JsonReader(run.out).read()["criterion"] == '"' + criterion + '"');
  }
  const Run run = run_stats(dir, testing::set_with_hidden_point());
  CHECK(run.status == 4);
  CHECK(JsonReader(run.out).read()["hidden"] == "1");
}

TEST_CASE("quiet says nothing; with stats, stats and nothing else") {
  const TempDir dir;
  dir.file("points.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  for (const char* word : {"-q", "--quiet"}) {
    const Run run = testing::run(dir, {"--method", "paper", word, "points.xyz", "surface.off"});
    CHECK(run.status == 0);
    CHECK(run.out.empty());
    CHECK(run.err.empty());
  }
  const Run run = run_stats(dir, point_sets::grid(2), {"-q"});
  CHECK(run.err.empty());
  CHECK(JsonReader(run.out).read()["vertices"] == "8");
}

TEST_CASE("a failure prints no object") {
  const TempDir dir;
  const Run run = run_stats(dir, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(run.status == 3);
  CHECK(run.out.empty());
}

TEST_CASE("a stdout that takes nothing is a failure") {
  if (!std::filesystem::exists("/dev/full")) return;
  const TempDir dir;
  dir.file("points.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  const Run run = testing::run(
      dir, {"--method", "paper", "--stats", "-q", "points.xyz", "surface.off"}, "", ">/dev/full");
  CHECK(run.status == 5);
  CHECK(run.err == "tetsculpt: standard output could not be written\n");
}

}  // namespace
}  // namespace tetsculpt
