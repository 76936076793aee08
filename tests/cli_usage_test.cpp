// The command line's own text: help, version, and what it says of a line that makes no sense.
#include <doctest/doctest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/sculpt_cli.h"

namespace tetsculpt {
namespace {

using testing::Run;
using testing::TempDir;

TEST_CASE("help goes to stdout and names every option and status") {
  const TempDir dir;
  for (const char* word : {"--help", "-h"}) {
    const Run run = testing::run(dir, {word});
    CHECK(run.status == 0);
    CHECK(run.err.empty());
    CHECK(run.out.starts_with("Usage: tetsculpt "));
    for (const std::string part :
         {"--method", "--criterion",     "--skip-invalid", "--threads", "--stats",      "--quiet",
          "--help",   "--version",       "constrained",    "longest",   "area",         "gamma",
          "paper",    "Exit status",     "\n  0 ",         "--picture", "--view",       "--up",
          "--input",  "--output",        "--dry-run",      "--graphs",  "--tetrahedra", "--normals",
          "--ascii",  "--no-attributes", "\n  1 ",         "\n  2 ",    "\n  3 ",       "\n  4 ",
          "\n  5 "}) {
      INFO(part);
      CHECK(run.out.find(part) != std::string::npos);
    }
  }
}

TEST_CASE("help fits a terminal") {
  const TempDir dir;
  std::istringstream lines(testing::run(dir, {"--help"}).out);
  for (std::string line; std::getline(lines, line);) {
    INFO(line);
    CHECK(line.size() < 80);
    CHECK_FALSE(line.ends_with(' '));
  }
}

TEST_CASE("version") {
  const TempDir dir;
  const Run run = testing::run(dir, {"--version"});
  CHECK(run.status == 0);
  CHECK(run.err.empty());
  CHECK(run.out == "tetsculpt " TETSCULPT_VERSION "\n");
}

TEST_CASE("help needs no files and wins over what follows it") {
  const TempDir dir;
  CHECK(testing::run(dir, {"--quiet", "--help", "--nonsense"}).status == 0);
  CHECK(testing::run(dir, {"--nonsense", "--help"}).status == 1);
}

TEST_CASE("wrong usage says why, on stderr, in one line") {
  const TempDir dir;
  dir.file("a.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  const std::vector<std::pair<std::vector<std::string>, std::string>> lines{
      {{}, "no input file given"},
      {{"--quiet"}, "no input file given"},
      {{"a.xyz"}, "no output file given"},
      {{"a.xyz", "b.ply", "c"}, "unexpected word 'c'"},
      {{"--nonsense", "a.xyz", "b.ply"}, "unknown option '--nonsense'"},
      {{"-x", "a.xyz", "b.ply"}, "unknown option '-x'"},
      {{"a.xyz", "b.ply", "--threads"}, "--threads needs a value"},
      {{"a.xyz", "b.ply", "--method"}, "--method needs a value"},
      {{"a.xyz", "b.ply", "--criterion"}, "--criterion needs a value"},
      {{"--quiet=yes", "a.xyz", "b.ply"}, "--quiet takes no value"},
      {{"--stats=", "a.xyz", "b.ply"}, "--stats= needs a file"},
      {{"--threads=0", "a.xyz", "b.ply"}, "--threads: '0' is not a number from 1 to 1024"},
      {{"--threads", "two", "a.xyz", "b.ply"}, "--threads: 'two' is not a number from 1 to 1024"},
      {{"--threads", "3x", "a.xyz", "b.ply"}, "--threads: '3x' is not a number from 1 to 1024"},
      {{"--threads", "99999999999", "a.xyz", "b.ply"},
       "--threads: '99999999999' is not a number from 1 to 1024"},
      {{"--criterion", "best", "a.xyz", "b.ply"},
       "--criterion: 'best' is none of area, gamma, longest, constrained"},
      {{"a.xyz", "b.doc"},
       "b.doc: unknown kind of output file; use .ply, .obj, .off, .stl, .wrl, .gltf, .glb or .vtk"},
      {{"a.xyz", "b"},
       "b: unknown kind of output file; use .ply, .obj, .off, .stl, .wrl, .gltf, .glb or .vtk"}};
  for (const auto& [words, message] : lines) {
    const Run run = testing::run(dir, words);
    CHECK(run.status == 1);
    CHECK(run.out.empty());
    CHECK(run.err == "tetsculpt: " + message + " ('tetsculpt --help' explains)\n");
  }
  const Run method = testing::run(dir, {"--method=", "a.xyz", "b.ply"});
  CHECK(method.status == 1);
  CHECK(method.err.starts_with("tetsculpt: --method: '' is none of "));
  CHECK(testing::names_in(dir) == std::vector<std::string>{"a.xyz"});
}

TEST_CASE("a value may be attached or follow, options may come last, -- ends them") {
  const TempDir dir;
  dir.file("-a.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  dir.file("it's a.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  const std::vector<std::vector<std::string>> lines{
      {"--method=paper", "--threads=2", "--criterion=area", "it's a.xyz", "b.ply"},
      {"it's a.xyz", "b.ply", "--method", "paper", "--threads", "2", "--criterion", "gamma"},
      {"it's a.xyz", "--method", "paper", "b.ply", "-q"},
      {"--method", "paper", "--", "-a.xyz", "-b.ply"},
      {"--method", "paper", "it's a.xyz", "B.PLY"}};
  for (const auto& words : lines) {
    const Run run = testing::run(dir, words);
    INFO(run.err);
    CHECK(run.status == 0);
  }
}

TEST_CASE("a stdout that takes nothing is a failure") {
  if (!std::filesystem::exists("/dev/full")) return;
  const TempDir dir;
  for (const std::string word : {"--help", "--version"}) {
    INFO(word);
    const Run run = testing::run(dir, {word}, "", ">/dev/full");
    CHECK(run.status == 5);
    CHECK_FALSE(run.err.empty());
  }
}

}  // namespace
}  // namespace tetsculpt
