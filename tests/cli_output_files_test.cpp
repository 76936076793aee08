// The output is written whole or not at all: after a failure there is no new file and an old one is
// as it was.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/support/point_sets.h"
#include "tests/support/sculpt_cli.h"

namespace tetsculpt {
namespace {

using testing::bytes_of;
using testing::Run;
using testing::TempDir;

constexpr std::string_view kExtensions[] = {".ply", ".obj",  ".off", ".stl",
                                            ".wrl", ".gltf", ".glb", ".vtk"};

TEST_CASE("every kind of file, on nothing or on an old one") {
  const TempDir dir;
  dir.file("points.xyz", testing::xyz(point_sets::uniform_cube(50, 1)));
  for (const std::string_view extension : kExtensions) {
    INFO(extension);
    const std::string name = "surface" + std::string(extension);
    for (const char* old : {"", "old"}) {
      if (*old != 0) dir.file(name, old);
      CHECK(testing::run(dir, {"--method", "paper", "points.xyz", name}).status == 0);
      CHECK(bytes_of(dir.path() / name).size() > 500);
    }
  }
  CHECK(testing::names_in(dir).size() == 9);
}

TEST_CASE("input and output may be one file") {
  const TempDir dir;
  const auto points = point_sets::uniform_cube(50, 1);
  dir.file("a.xyz", testing::xyz(points));
  REQUIRE(testing::run(dir, {"--method", "paper", "a.xyz", "a.off"}).status == 0);
  const std::string first = bytes_of(dir.path() / "a.off");
  REQUIRE(testing::run(dir, {"--method", "paper", "a.off", "a.off"}).status == 0);
  CHECK(bytes_of(dir.path() / "a.off") == first);
  CHECK(testing::mesh_of_off(dir.path() / "a.off").points == points);
}

TEST_CASE("bad input and no solid: nothing new, nothing changed") {
  const TempDir dir;
  dir.file("broken.xyz", "0 0 0\n1 0 0\nzero\n");
  dir.file("nan.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\nnan 0 0\n");
  dir.file("plane.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
  const std::vector<std::string> before = testing::names_in(dir);
  for (const auto& [name_of_input, status] :
       {std::pair{"broken.xyz", 2}, std::pair{"nan.xyz", 2}, std::pair{"plane.xyz", 3},
        std::pair{"none.xyz", 2}}) {
    const std::string input = name_of_input;
    for (const std::string_view extension : kExtensions) {
      INFO(input, " to ", extension);
      const std::string name = "new" + std::string(extension);
      CHECK(testing::run(dir, {"--method", "paper", input, name}).status == status);
      CHECK(testing::names_in(dir) == before);
    }
    const auto old = dir.file("old.ply", "as it was");
    CHECK(testing::run(dir, {"--method", "paper", input, "old.ply"}).status == status);
    CHECK(bytes_of(old) == "as it was");
    std::filesystem::remove(old);
    CHECK(testing::names_in(dir) == before);
  }
}

TEST_CASE("a file that can't grow to its size: nothing new, nothing changed") {
  const TempDir dir;
  dir.file("points.xyz", testing::xyz(point_sets::uniform_cube(500, 1)));
  for (const std::string_view extension : kExtensions) {
    const std::string name = "surface" + std::string(extension);
    for (const bool over_old : {false, true}) {
      INFO(name, over_old ? ", over an old one" : "");
      if (over_old) dir.file(name, "as it was");
      const std::vector<std::string> before = testing::names_in(dir);
      const Run run = testing::run(dir, {"--method", "paper", "points.xyz", name}, "ulimit -f 2;");
      CHECK(run.status == 5);
      CHECK(run.err.starts_with("tetsculpt: " + name + ": cannot write: "));
      CHECK(testing::names_in(dir) == before);
      if (over_old) CHECK(bytes_of(dir.path() / name) == "as it was");
    }
  }
}

TEST_CASE("a device that is full") {
  if (!std::filesystem::exists("/dev/full")) return;
  const TempDir dir;
  dir.file("points.xyz", testing::xyz(point_sets::uniform_cube(500, 1)));
  for (const std::string_view extension : kExtensions) {
    const std::string name = "full" + std::string(extension);
    INFO(name);
    std::filesystem::create_symlink("/dev/full", dir.path() / name);
    const Run run = testing::run(dir, {"--method", "paper", "points.xyz", name});
    CHECK(run.status == 5);
    CHECK(run.err.starts_with("tetsculpt: " + name + ": "));
    CHECK(std::filesystem::is_symlink(dir.path() / name));
  }
}

TEST_CASE("a pipe whose reader has gone") {
  const TempDir dir;
  dir.file("points.xyz", testing::xyz(point_sets::uniform_cube(3000, 1)));
  for (const std::string_view extension : kExtensions) {
    const std::string name = "pipe" + std::string(extension);
    INFO(name);
    REQUIRE(mkfifo((dir.path() / name).c_str(), 0600) == 0);
    // The file is larger than what a pipe holds.
    const Run run = testing::run(dir, {"--method", "paper", "points.xyz", name},
                                 "{ head -c 1 <" + name + " >head & };");
    CHECK(run.status == 5);
    CHECK(run.err.starts_with("tetsculpt: " + name + ": cannot write: Broken pipe"));
  }
}

}  // namespace
}  // namespace tetsculpt
