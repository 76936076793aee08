// `tetsculpt info`: what it says of a file of points.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/point_sets.h"
#include "tests/support/sculpt_cli.h"
#include "tests/support/sculpt_json.h"

namespace tetsculpt {
namespace {

using testing::JsonMembers;
using testing::JsonReader;
using testing::Run;
using testing::TempDir;

JsonMembers info(const std::string& name, const std::string& content) {
  const TempDir dir;
  dir.file(name, content);
  const Run run = testing::run(dir, {"info", "--json", name});
  CHECK(run.status == 0);
  CHECK(run.err.empty());
  CHECK(std::ranges::count(run.out, '\n') == 1);
  return JsonReader(run.out).read();
}

TEST_CASE("counts, box and spacing") {
  // A grid with one point moved, one repeated, and one that is none.
  std::vector<Point3> points = point_sets::grid(3);
  points.push_back({10, 0, 0});
  points.push_back(points[4]);
  JsonMembers json = info("a.csv", testing::xyz(points) + "0 inf 0\n");
  CHECK(json["points"] == "30");
  CHECK(json["invalid"] == "1");
  CHECK(json["duplicates"] == "1");
  CHECK(json["distinct"] == "28");
  CHECK(json["span"] == "\"solid\"");
  CHECK(json["format"] == "\"csv\"");
  CHECK(json["precision"] == "\"double\"");
  CHECK(json["lowest[0]"] == "0");
  CHECK(json["highest[0]"] == "10");
  CHECK(json["highest[2]"] == "2");
  CHECK(json["spacing.least"] == "1");
  CHECK(json["spacing.median"] == "1");
  CHECK(json["spacing.three_quarters"] == "1");
  CHECK(json["spacing.largest"] == "8");
}

TEST_CASE("the format is that of the content, whatever the file is called") {
  const std::string text = "0 0 0\n1 2 3\n";
  CHECK(info("scan", text)["format"] == "\"xyz\"");
  CHECK(info("scan.unknown", text)["format"] == "\"xyz\"");
  CHECK(info("a.CSV", text)["format"] == "\"csv\"");
  CHECK(info("a.xyz", "OFF\n2 0 0\n" + text)["format"] == "\"off\"");
}

TEST_CASE("what they span") {
  CHECK(info("a.xyz", "")["span"] == "\"nothing\"");
  CHECK(info("a.xyz", "")["spacing"] == "null");
  CHECK(info("a.xyz", "")["lowest"] == "null");
  CHECK(info("a.xyz", "1 2 3\n1 2 3\n")["span"] == "\"point\"");
  CHECK(info("a.xyz", "1 2 3\n2 3 4\n4 5 6\n")["span"] == "\"line\"");
  CHECK(info("a.xyz", "1 2 3\n2 3 4\n4 5 7\n")["span"] == "\"plane\"");
  CHECK(info("a.xyz", "0 0 0\n0 3 4\n0 6 8\n")["spacing.median"] == "5");
}

TEST_CASE("coordinates beyond the range of exact arithmetic, scaled") {
  CHECK(info("a.xyz", "0 0 0\n0 3e300 4e300\n")["spacing.least"] == "5e+300");
}

TEST_CASE("precision of the file") {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nend_header\n0 0 0\n";
  CHECK(info("a.ply", ply)["precision"] == "\"single\"");
}

TEST_CASE("for people") {
  const TempDir dir;
  dir.file("a.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  const Run run = testing::run(dir, {"info", "a.xyz"});
  CHECK(run.status == 0);
  for (const std::string text :
       {"a.xyz: 4 points\n", "span          a solid\n", "lowest        0 0 0\n",
        "spacing       median 1, half from 1 to 1, all from 1 to 1\n"}) {
    CHECK(run.out.find(text) != std::string::npos);
  }
}

TEST_CASE("statuses") {
  const TempDir dir;
  dir.file("wide.xyz", "1e300 1e-300 0\n");
  dir.file("a.xyz", "0 0\n");
  CHECK(testing::run(dir, {"info", "a.xyz"}).status == 2);
  CHECK(testing::run(dir, {"info", "wide.xyz"}).status == 2);
  CHECK(testing::run(dir, {"info", "none.xyz"}).status == 2);
  CHECK(testing::run(dir, {"info"}).status == 1);
  CHECK(testing::run(dir, {"info", "--points", "a.xyz", "b.xyz"}).status == 1);
  CHECK(testing::run(dir, {"info", "-h"}).status == 0);
}

}  // namespace
}  // namespace tetsculpt
