// IoError names the path and the place, in words and as data.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "io/io_error.h"
#include "io/read_points.h"
#include "io/write_mesh.h"
#include "tests/support/io_files.h"

namespace tetsculpt {
namespace {

using testing::TempDir;

TEST_CASE("a whole file") {
  const IoError error("a/b.ply", "is missing");
  CHECK(std::string(error.what()) == "a/b.ply: is missing");
  CHECK(error.path() == "a/b.ply");
  CHECK_FALSE(error.line());
  CHECK_FALSE(error.byte());
}

TEST_CASE("a line") {
  const IoError error("a.xyz", LineNumber{7}, "bad");
  CHECK(std::string(error.what()) == "a.xyz:7: bad");
  CHECK(error.line() == 7);
  CHECK_FALSE(error.byte());
}

TEST_CASE("a byte") {
  const IoError error("a.ply", ByteOffset{0}, "bad");
  CHECK(std::string(error.what()) == "a.ply: byte 0: bad");
  CHECK(error.byte() == 0);
  CHECK_FALSE(error.line());
}

std::string message_of_reading(const std::filesystem::path& path) {
  try {
    read_points(path);
  } catch (const IoError& error) {
    CHECK(error.path() == path);
    return error.what();
  }
  return "";
}

TEST_CASE("files that cannot be read at all") {
  const TempDir dir;
  const std::string missing = (dir.path() / "missing.xyz").string();
  CHECK(message_of_reading(missing) == missing + ": cannot open: No such file or directory");

  const std::filesystem::path directory = dir.path() / "directory.ply";
  std::filesystem::create_directory(directory);
  CHECK(message_of_reading(directory) == directory.string() + ": is a directory");

  for (const char* name : {"points", "points.", ".ply"}) {
    CAPTURE(name);
    const std::filesystem::path path = dir.file(name, "{ \"vertices\": [] }\n");
    CHECK(message_of_reading(path) ==
          path.string() +
              ": not a known kind of point file (known: .xyz .txt .csv .pts .asc .ply "
              ".obj .off .stl .pcd .las .vtk)");
  }
  const std::filesystem::path other = dir.file("points.Json", "{}\n");
  CHECK(message_of_reading(other).find("nor is the extension '.json'") != std::string::npos);
}

TEST_CASE("an unknown extension is refused before anything is written") {
  const TempDir dir;
  for (const char* name : {"mesh.xyz", "mesh", "mesh.gltf.txt", ".ply"}) {
    CAPTURE(name);
    CHECK_FALSE(writable_mesh_extension(name));
    CHECK_THROWS_AS(write_mesh({}, dir.path() / name), IoError);
  }
  CHECK(std::filesystem::is_empty(dir.path()));
  for (const char* name : {"m.ply", "m.obj", "m.off", "m.stl", "m.wrl", "m.gltf", "m.glb", "m.vtk",
                           "M.PLY", "m.x.Wrl"}) {
    CAPTURE(name);
    CHECK(writable_mesh_extension(name));
  }
}

}  // namespace
}  // namespace tetsculpt
