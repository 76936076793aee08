// A file is written whole or not at all, and a failure leaves nothing behind.
#include <doctest/doctest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "io/atomic_file.h"
#include "io/io_error.h"
#include "io/write_mesh.h"
#include "tests/support/io_files.h"

namespace tetsculpt {
namespace {

namespace fs = std::filesystem;
using testing::bytes_of;
using testing::TempDir;

std::ptrdiff_t files_in(const TempDir& dir) {
  return std::distance(fs::directory_iterator(dir.path()), {});
}

std::string failure(const TriangleMesh& mesh, const fs::path& path) {
  try {
    write_mesh(mesh, path);
  } catch (const IoError& error) {
    CHECK(error.path() == path);
    return std::string(error.what()).substr(path.string().size());
  }
  return "written";
}

TEST_CASE("the target changes at commit, not before") {
  const TempDir dir;
  const fs::path path = dir.file("a.txt", "old");
  {
    AtomicFile file(path);
    file.write("new");
    CHECK(bytes_of(path) == "old");
    CHECK(files_in(dir) == 2);
    file.commit();
    CHECK(bytes_of(path) == "new");
  }
  CHECK(bytes_of(path) == "new");
  CHECK(files_in(dir) == 1);
}

TEST_CASE("without commit nothing happens") {
  const TempDir dir;
  const fs::path path = dir.file("a.txt", "old");
  { AtomicFile(path).write(std::string(1 << 20, 'n')); }
  { AtomicFile(dir.path() / "b.txt").write("new"); }
  CHECK(bytes_of(path) == "old");
  CHECK(files_in(dir) == 1);
}

TEST_CASE("pieces of every size arrive in order") {
  const TempDir dir;
  std::string all;
  AtomicFile file(dir.path() / "a.txt");
  for (std::size_t size = 0; size < 3'000'000; size = size * 3 + 1) {
    const std::string piece(size, static_cast<char>('a' + size % 26));
    file.write(piece);
    all += piece;
  }
  file.commit();
  CHECK(bytes_of(dir.path() / "a.txt") == all);
}

TEST_CASE("a mesh that fails half-way leaves the old file") {
  const TempDir dir;
  const fs::path path = dir.file("a.stl", "old");
  const TriangleMesh too_large = {{{0, 0, 0}, {1, 0, 0}, {0, 1e300, 0}}, {{0, 1, 2}}};
  CHECK(failure(too_large, path) == ": point 2 is too large for the floats of STL");
  CHECK(bytes_of(path) == "old");
  CHECK(files_in(dir) == 1);
}

TEST_CASE("a write that the system refuses leaves the old file") {
  const TempDir dir;
  const fs::path path = dir.file("a.obj", "old");
  const TriangleMesh large{std::vector<Point3>(100'000), {}};
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 300'000;
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string message = failure(large, path);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  CHECK(message == ": cannot write: File too large");
  CHECK(bytes_of(path) == "old");
  CHECK(files_in(dir) == 1);
}

TEST_CASE("a directory that is missing, a file in its place, a directory as target") {
  const TempDir dir;
  CHECK(failure({}, dir.path() / "none" / "a.ply") == ": cannot create: No such file or directory");
  const fs::path file = dir.file("file", "");
  CHECK(failure({}, file / "a.ply") == ": cannot create: Not a directory");
  fs::create_directory(dir.path() / "d.ply");
  CHECK(failure({}, dir.path() / "d.ply") == ": cannot create: Is a directory");
  CHECK(files_in(dir) == 2);
}

TEST_CASE("a full device") {
  if (!fs::is_character_file("/dev/full")) return;
  const TempDir dir;
  const fs::path path = dir.path() / "a.ply";
  fs::create_symlink("/dev/full", path);
  CHECK(failure({}, path) == ": cannot write: No space left on device");
  CHECK(fs::is_character_file("/dev/full"));
  CHECK(files_in(dir) == 1);
}

TEST_CASE("a link stays a link, and the file keeps its permissions") {
  const TempDir dir;
  const fs::path file = dir.file("file.obj", "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("file.obj", dir.path() / "link.obj");
  write_mesh({}, dir.path() / "link.obj");
  CHECK(fs::is_symlink(dir.path() / "link.obj"));
  CHECK(bytes_of(file) == "# made by tetsculpt\n");
  CHECK(fs::status(file).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
  CHECK(files_in(dir) == 2);
}

TEST_CASE("a pipe is written, not replaced") {
  const TempDir dir;
  const fs::path path = dir.path() / "pipe.obj";
  REQUIRE(mkfifo(path.c_str(), 0600) == 0);
  std::string got;
  std::thread reader([&] { got = bytes_of(path); });
  write_mesh({}, path);
  reader.join();
  CHECK(got == "# made by tetsculpt\n");
  CHECK(fs::is_fifo(path));
  CHECK(files_in(dir) == 1);
}

}  // namespace
}  // namespace tetsculpt
