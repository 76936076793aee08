// SIGINT, SIGTERM and SIGHUP end a run wherever it is, and leave no file.
#include <doctest/doctest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
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

// The signal may come before, in or after the writing of any of the files.
TEST_CASE("while it writes: whole files only") {
  const TempDir dir;
  dir.file("a.xyz", testing::xyz(point_sets::bumpy_sphere(5000, 1)));
  const std::vector<std::string> words{"--progress", "--picture", "a.png", "--graphs",
                                       "a",          "a.xyz",     "a.obj"};
  REQUIRE(testing::run(dir, words).status == 0);
  const TempDir whole;
  for (const std::string& name : testing::names_in(dir)) {
    std::filesystem::copy(dir.path() / name, whole.path() / name);
  }
  for (int pause = 0; pause < 12; ++pause) {
    for (const std::string& name : testing::names_in(dir)) {
      if (name != "a.xyz") std::filesystem::remove(dir.path() / name);
    }
    Child child(dir, words);
    REQUIRE(child.said("write, "));
    std::this_thread::sleep_for(pause * std::chrono::milliseconds(3));
    child.send(SIGINT);
    const int status = child.wait();
    CHECK((status == 0 || status == 128 + SIGINT));
    for (const std::string& name : testing::names_in(dir)) {
      INFO(name, " after pause ", pause);
      CHECK(testing::bytes_of(dir.path() / name) == testing::bytes_of(whole.path() / name));
    }
  }
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
