// Progress: lines or one line, each stage in its order, shares that grow, and nothing for what is
// quick.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/point_sets.h"
#include "tests/support/sculpt_child.h"
#include "tests/support/sculpt_cli.h"

namespace tetsculpt {
namespace {

using testing::Child;
using testing::Run;
using testing::TempDir;

constexpr const char* kStages[] = {"read", "delaunay", "graphs", "sculpt", "write"};

/// The shares told, after a check that the stages come in their order.
std::vector<int> shares(const std::string& text) {
  std::vector<int> out;
  std::size_t at = 0;
  for (const char* stage : kStages) {
    INFO(stage);
    const std::size_t found = text.find("tetsculpt: " + std::string(stage) + ", ", at);
    REQUIRE(found != std::string::npos);
    at = found;
    out.push_back(std::stoi(text.substr(text.find(", ", at) + 2)));
  }
  return out;
}

TEST_CASE("elsewhere than on a terminal: a line per stage, then the summary") {
  const TempDir dir;
  dir.file("a.xyz", testing::xyz(point_sets::torus(0.2, 1)));
  for (const std::string method : {"guided", "paper"}) {
    const Run run = testing::run(dir, {"--progress", "--method", method, "a.xyz", "b.ply"});
    CHECK(run.status == 0);
    CHECK(run.out.empty());
    CHECK(run.err.find('\r') == std::string::npos);
    const std::vector<int> told = shares(run.err);
    CHECK(told.front() == 0);
    CHECK(told.back() < 100);
    CHECK(std::ranges::is_sorted(told));
    CHECK(std::ranges::adjacent_find(told) == told.end());
    const std::string last = run.err.substr(run.err.rfind('\n', run.err.size() - 2) + 1);
    CHECK(last.starts_with("b.ply: "));
  }
}

TEST_CASE("on a terminal: one line, taken back before the summary") {
  const TempDir dir;
  dir.file("a.xyz", testing::xyz(point_sets::torus(0.2, 1)));
  Child child(dir, {"--progress", "a.xyz", "b.ply"}, Child::Stderr::kTerminal);
  CHECK(child.wait() == 0);
  const std::string& err = child.err();
  shares(err);
  CHECK(std::ranges::count(err, '\n') == 1);
  CHECK(err.find("\r\x1b[Kb.ply: ") != std::string::npos);
  std::size_t lines = 0;
  for (std::size_t at = err.find("tetsculpt: "); at != std::string::npos;
       at = err.find("tetsculpt: ", at + 1)) {
    CHECK(err.substr(at - 1, 1) == "\r");
    ++lines;
  }
  CHECK(lines >= 5);
}

TEST_CASE("a failure comes on a line of its own") {
  const TempDir dir;
  dir.file("plane.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
  Child child(dir, {"--progress", "plane.xyz", "b.ply"}, Child::Stderr::kTerminal);
  CHECK(child.wait() == 3);
  CHECK(child.err().find("\r\x1b[Ktetsculpt: plane.xyz: ") != std::string::npos);
}

TEST_CASE("verbose: a line per stage with its time, after the work") {
  const TempDir dir;
  dir.file("a.xyz", testing::xyz(point_sets::torus(0.2, 1)));
  const Run run = testing::run(dir, {"-v", "a.xyz", "b.ply"});
  CHECK(run.status == 0);
  std::istringstream lines(run.err);
  std::string line;
  for (const char* stage : kStages) {
    std::getline(lines, line);
    CHECK(line.starts_with("tetsculpt: " + std::string(stage) + ": "));
    CHECK(line.ends_with(" s)"));
  }
}

}  // namespace
}  // namespace tetsculpt
