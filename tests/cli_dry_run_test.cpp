// --dry-run reads, checks and says what there is, ends as a whole run would, and writes nothing.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/support/sculpt_cli.h"

namespace tetsculpt {
namespace {

using testing::Run;
using testing::TempDir;

constexpr const char* kPoints = "0 0 0\n1 0.5 0\n0 -2.5 0\n1 0.5 0\n0 0 1e10\n";

TEST_CASE("count, duplicates, invalid ones and the box") {
  const TempDir dir;
  dir.file("a.xyz", std::string(kPoints) + "nan 1 1\n");
  const std::vector<std::vector<std::string>> lines{{"--dry-run", "--skip-invalid", "a.xyz"},
                                                    {"-n", "--skip-invalid", "a.xyz", "b.ply"}};
  for (const auto& words : lines) {
    const Run run = testing::run(dir, words);
    CHECK(run.status == 0);
    CHECK(run.err.empty());
    CHECK(run.out ==
          "a.xyz: 6 points\n"
          "format        xyz, coordinates as 64-bit floats\n"
          "invalid       1\nduplicates    1\nspan          a solid\n"
          "lowest        0 -2.5 0\nhighest       1 0.5 1e+10\n");
  }
  CHECK(testing::names_in(dir) == std::vector<std::string>{"a.xyz"});
}

TEST_CASE("a float's digits, if the file has floats") {
  const TempDir dir;
  dir.file("a.ply",
           "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
           "property float z\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 0.1\n");
  CHECK(testing::run(dir, {"-n", "a.ply"}).out.ends_with("highest       1 1 0.1\n"));
}

TEST_CASE("as info, but for the spacing") {
  const TempDir dir;
  dir.file("a.csv", "x,y,z,height\n0,0,0,1\n1,0,0,2\n0,1,0,3\n0,0,1,4\n");
  std::string info = testing::run(dir, {"info", "a.csv"}).out;
  const std::size_t spacing = info.find("spacing");
  REQUIRE(spacing != std::string::npos);
  info.erase(spacing, info.find('\n', spacing) + 1 - spacing);
  CHECK(testing::run(dir, {"--dry-run", "a.csv"}).out == info);
}

TEST_CASE("the statuses and messages of a whole run") {
  const TempDir dir;
  dir.file("nan.xyz", std::string(kPoints) + "nan 1 1\n");
  dir.file("plane.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
  dir.file("empty.xyz", "");
  dir.file("broken.xyz", "0 0\n");
  for (const std::string name : {"nan.xyz", "plane.xyz", "empty.xyz", "broken.xyz", "none.xyz"}) {
    INFO(name);
    const Run dry = testing::run(dir, {"--dry-run", name});
    const Run whole = testing::run(dir, {name, "b.ply"});
    CHECK(dry.status == whole.status);
    CHECK(dry.status != 0);
    CHECK(dry.err == whole.err);
  }
}

TEST_CASE("quiet: the status alone") {
  const TempDir dir;
  dir.file("a.xyz", kPoints);
  const Run run = testing::run(dir, {"-nq", "a.xyz"});
  CHECK(run.status == 0);
  CHECK(run.out.empty());
  CHECK(run.err.empty());
}

}  // namespace
}  // namespace tetsculpt
