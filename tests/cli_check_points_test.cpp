// `tetsculpt check --points` and `--json`.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/check_runs.h"
#include "tests/support/meshes.h"
#include "tests/support/sculpt_cli.h"
#include "tests/support/sculpt_json.h"

namespace tetsculpt {
namespace {

using testing::check;
using testing::cube;
using testing::JsonReader;
using testing::Run;
using testing::says;
using testing::TempDir;

TEST_CASE("points: all are vertices, and no vertex is anything else") {
  const TempDir dir;
  const TriangleMesh mesh = cube(0.1, 0.7);
  dir.file("p.xyz", testing::xyz(mesh.points) + testing::xyz({mesh.points[2]}) + "nan 0 0\n");
  for (const std::string name : {"m.off", "m.stl"}) {
    INFO(name);
    const Run run = check(dir, mesh, {"--points", "p.xyz"}, name);
    CHECK(run.status == 0);
    CHECK(says(run, "8 distinct of 10 in p.xyz, 1 invalid one left out"));
    CHECK(says(run, "as 32-bit floats") == (name == "m.stl"));
  }
  dir.file("q.xyz", testing::xyz(mesh.points) + "0 0 0\n");
  const Run missing = check(dir, mesh, {"--points=q.xyz"});
  CHECK(missing.status == 6);
  CHECK(says(missing, "fault         1 point of q.xyz not among the vertices; it is number 8\n"));
  dir.file("r.xyz", "0.1 0.1 0.1\n");
  const Run invented = check(dir, mesh, {"--points", "r.xyz"});
  CHECK(says(invented, "7 vertices not among the points of r.xyz; the first is number 1\n"));
}

TEST_CASE("json") {
  const TempDir dir;
  const TriangleMesh mesh = testing::with(cube(-2, 2), testing::inverted(cube(-1, 1)));
  dir.file("p.xyz", testing::xyz(mesh.points));
  for (const std::string option : {"--json", "--stats"}) {
    const Run run = check(dir, mesh, {option, "--points", "p.xyz"}, "a\"b.off");
    CHECK(run.status == 0);
    CHECK(std::ranges::count(run.out, '\n') == 1);
    auto json = JsonReader(run.out).read();
    CHECK(json["file"] == "\"a\"b.off\"");
    CHECK(json["flawless"] == "true");
    CHECK(json["components"] == "2");
    CHECK(json["genus"] == "0");
    CHECK(json["volume"] == "56");
    CHECK(json["outward"] == "true");
    CHECK(json["faults.open_edges"] == "0");
    CHECK(json["faults.missing"] == "0");
    CHECK(json["points.distinct"] == "16");
    CHECK(json["shells[1].depth"] == "1");
    CHECK(json["shells[1].volume"] == "-8");
  }
  TriangleMesh open = cube(-1, 1);
  open.triangles.pop_back();
  const Run run = check(dir, open, {"--json"});
  CHECK(run.status == 6);
  auto json = JsonReader(run.out).read();
  CHECK(json["flawless"] == "false");
  CHECK(json["faults.open_edges"] == "3");
  CHECK(json["shells[0].volume"] == "null");
}

}  // namespace
}  // namespace tetsculpt
