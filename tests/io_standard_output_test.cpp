// Meshes on standard output: the bytes of a file, and a failure where they can't go.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "io/io_error.h"
#include "io/write_mesh.h"
#include "tests/support/io_files.h"

namespace tetsculpt {
namespace {

using testing::TempDir;

/// Standard output is `target` as long as it lives.
class Redirected {
 public:
  explicit Redirected(int target) {
    std::fflush(stdout);
    dup2(target, STDOUT_FILENO);
    close(target);
  }
  ~Redirected() {
    std::fflush(stdout);
    std::clearerr(stdout);
    dup2(old_, STDOUT_FILENO);
    close(old_);
  }
  Redirected(const Redirected&) = delete;
  Redirected& operator=(const Redirected&) = delete;

 private:
  int old_ = dup(STDOUT_FILENO);
};

TriangleMesh large() {
  TriangleMesh mesh{std::vector<Point3>(50'000, {0.1, 0.2, 0.3}), {}};
  mesh.triangles.assign(50'000, {0, 1, 2});
  return mesh;
}

/// What writing says when standard output is `target`.
std::string failure(int target, MeshFormat format) {
  const Redirected redirected(target);
  try {
    write_mesh_to_standard_output(large(), {.format = format});
  } catch (const IoError& error) {
    return error.what();
  }
  return "written";
}

constexpr std::array<MeshFormat, 8> kFormats = {
    MeshFormat::kPly,  MeshFormat::kObj,  MeshFormat::kOff, MeshFormat::kStl,
    MeshFormat::kVrml, MeshFormat::kGltf, MeshFormat::kGlb, MeshFormat::kVtk};

TEST_CASE("the same bytes and the same report as a file, twice in a row") {
  const TempDir dir;
  for (const MeshFormat format : kFormats) {
    const WriteReport report = write_mesh(large(), dir.path() / "file", {.format = format});
    const auto path = dir.file("out", "");
    {
      const Redirected redirected(open(path.c_str(), O_WRONLY | O_APPEND));
      const WriteReport same = write_mesh_to_standard_output(large(), {.format = format});
      write_mesh_to_standard_output(large(), {.format = format});
      CHECK(same == report);
    }
    const std::string bytes = testing::bytes_of(dir.path() / "file");
    CHECK((testing::bytes_of(path) == bytes + bytes));
  }
}

TEST_CASE("a full device") {
  if (!std::filesystem::exists("/dev/full")) return;
  for (const MeshFormat format : kFormats) {
    CHECK(failure(open("/dev/full", O_WRONLY), format) ==
          "standard output: cannot write: No space left on device");
  }
}

TEST_CASE("a pipe that nobody reads") {
  const auto old_handler = std::signal(SIGPIPE, SIG_IGN);
  for (const MeshFormat format : kFormats) {
    std::array<int, 2> ends{};
    REQUIRE(pipe(ends.data()) == 0);
    close(ends[0]);
    CHECK(failure(ends[1], format) == "standard output: cannot write: Broken pipe");
  }
  std::signal(SIGPIPE, old_handler);
}

}  // namespace
}  // namespace tetsculpt
