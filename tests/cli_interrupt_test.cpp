// SIGINT, SIGTERM and SIGHUP end a run wherever it is, and leave no file.
#include <doctest/doctest.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "tests/support/point_sets.h"
#include "tests/support/sculpt_child.h"
#include "tests/support/sculpt_cli.h"

namespace tetsculpt {
namespace {

using testing::Child;
using testing::TempDir;

using Names = std::vector<std::string>;

TEST_CASE("while it waits for its input") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    INFO("signal ", signal);
    const TempDir dir;
    Child child(dir, {"--progress", "--input-format=xyz", "-", "a.ply"});
    REQUIRE(child.said("read, "));
    child.send(signal);
    CHECK(child.wait() == 128 + signal);
    CHECK(child.err().ends_with("tetsculpt: interrupted\n"));
    CHECK(testing::names_in(dir).empty());
  }
}

TEST_CASE("at each stage, an old file stays as it was") {
  const TempDir dir;
  dir.file("a.xyz", testing::xyz(point_sets::bumpy_sphere(60000, 1)));
  for (const std::string stage : {"delaunay", "graphs", "sculpt"}) {
    INFO(stage);
    dir.file("old.ply", "as it was");
    Child child(dir, {"--progress", "--threads=2", "a.xyz", "old.ply"});
    REQUIRE(child.said(stage + ", "));
    child.send(SIGINT);
    CHECK(child.wait() == 128 + SIGINT);
    CHECK(testing::names_in(dir) == Names{"a.xyz", "old.ply"});
    CHECK(testing::bytes_of(dir.path() / "old.ply") == "as it was");
  }
}

/// A temporary file with something in it.
bool temporary_in(const TempDir& dir) {
  std::error_code gone;
  for (const auto& entry : std::filesystem::directory_iterator(dir.path())) {
    if (entry.path().extension() == ".tmp" && entry.file_size(gone) > 0 && !gone) return true;
  }
  return false;
}

/// Stops a run while it has a temporary file and interrupts it then. False if it was faster.
bool interrupted_while_writing(const TempDir& dir) {
  Child child(dir, {"--progress", "a.xyz", "old.obj"});
  REQUIRE(child.said("write, "));
  for (int look = 0; look < 100000 && !temporary_in(dir); ++look) {
    if (testing::bytes_of(dir.path() / "old.obj") != "as it was") break;
  }
  child.send(SIGSTOP);
  const bool writing = temporary_in(dir);
  child.send(SIGINT);
  child.send(SIGCONT);
  const int status = child.wait();
  CHECK((status == 0 || status == 128 + SIGINT));
  return writing && status != 0;
}

TEST_CASE("while it writes: no temporary file, an old file as it was") {
  const TempDir dir;
  dir.file("a.xyz", testing::xyz(point_sets::bumpy_sphere(60000, 1)));
  bool interrupted = false;
  for (int attempt = 0; attempt < 20 && !interrupted; ++attempt) {
    dir.file("old.obj", "as it was");
    interrupted = interrupted_while_writing(dir);
    CHECK(testing::names_in(dir) == Names{"a.xyz", "old.obj"});
    if (interrupted) CHECK(testing::bytes_of(dir.path() / "old.obj") == "as it was");
  }
  CHECK(interrupted);
}

TEST_CASE("a signal that is ignored, as under nohup, stays so") {
  const TempDir dir;
  Child child(dir, {"--progress", "--input-format=xyz", "-", "a.ply"}, Child::Stderr::kPipe,
              SIGHUP);
  REQUIRE(child.said("read, "));
  child.send(SIGHUP);
  child.close_input();
  CHECK(child.wait() == 3);
}

}  // namespace
}  // namespace tetsculpt
