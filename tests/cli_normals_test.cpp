// --normals, --ascii, and the lines about what a file does not hold.
#include <doctest/doctest.h>

#include <string>

#include "tests/support/sculpt_cli.h"

namespace tetsculpt {
namespace {

using testing::bytes_of;
using testing::Run;
using testing::TempDir;

constexpr const char* kTetrahedron = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_CASE("normals of the surface, as text") {
  const TempDir dir;
  dir.file("a.xyz", kTetrahedron);
  const Run run = testing::run(dir, {"-q", "--normals", "--ascii", "a.xyz", "b.ply"});
  CHECK(run.status == 0);
  CHECK(run.err.empty());
  const std::string text = bytes_of(dir.path() / "b.ply");
  CHECK(text.starts_with("ply\nformat ascii 1.0\n"));
  CHECK(contains(text,
                 "property double z\nproperty float nx\nproperty float ny\nproperty float nz\n"));
  CHECK(contains(text, "\n0 0 0 -0.57735026 -0.57735026 -0.57735026\n"));
}

TEST_CASE("what is not in the file is said, quiet or not; what is, is not") {
  const TempDir dir;
  dir.file("a.xyz", "0.1 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  const Run stl = testing::run(dir, {"-q", "--normals", "a.xyz", "b.stl"});
  CHECK(stl.status == 0);
  CHECK(stl.err ==
        "tetsculpt: b.stl: rounded to 32-bit floats: x\n"
        "tetsculpt: b.stl: not in this format: nx ny nz\n");
  for (const char* name : {"b.ply", "b.obj", "b.off", "b.wrl", "b.vtk"}) {
    CHECK(testing::run(dir, {"-q", "--normals", "a.xyz", name}).err.empty());
  }
  dir.file("a.xyz", kTetrahedron);
  for (const char* name : {"b.stl", "b.gltf", "b.glb"}) {
    CHECK(testing::run(dir, {"-q", "a.xyz", name}).err.empty());
  }
}

TEST_CASE("--ascii is for ply") {
  const TempDir dir;
  dir.file("a.xyz", kTetrahedron);
  const Run run = testing::run(dir, {"--ascii", "a.xyz", "b.obj"});
  CHECK(run.status == 1);
  CHECK(run.err ==
        "tetsculpt: --ascii is for .ply files; b.obj is none ('tetsculpt --help' explains)\n");
}

}  // namespace
}  // namespace tetsculpt
