// Options: -i and -o, letters in one word, standard input, formats by name, what excludes what, and
// what is said of a typo.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/sculpt_cli.h"

namespace tetsculpt {
namespace {

using testing::bytes_of;
using testing::Run;
using testing::TempDir;

constexpr const char* kTetrahedron = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

TEST_CASE("the files in all their places") {
  const TempDir dir;
  dir.file("a.xyz", kTetrahedron);
  REQUIRE(testing::run(dir, {"a.xyz", "first.off"}).status == 0);
  const std::vector<std::vector<std::string>> lines{
      {"-i", "a.xyz", "-o", "b.off"},         {"-ia.xyz", "-ob.off"},   {"-qia.xyz", "-ob.off"},
      {"--input=a.xyz", "--output", "b.off"}, {"-o", "b.off", "a.xyz"}, {"b.off", "-i", "a.xyz"}};
  for (const auto& words : lines) {
    const Run run = testing::run(dir, words);
    INFO(words[0], run.err);
    CHECK(run.status == 0);
    CHECK(bytes_of(dir.path() / "b.off") == bytes_of(dir.path() / "first.off"));
    std::filesystem::remove(dir.path() / "b.off");
  }
}

TEST_CASE("a format by name goes before the extension") {
  const TempDir dir;
  dir.file("a.dat", kTetrahedron);
  CHECK(testing::run(dir, {"--input-format", "xyz", "--output-format=off", "a.dat", "b.ply"})
            .status == 0);
  CHECK(bytes_of(dir.path() / "b.ply").starts_with("OFF"));
}

TEST_CASE("standard input") {
  const TempDir dir;
  dir.file("a.xyz", kTetrahedron);
  const Run run = testing::run(dir, {"--input-format=xyz", "-", "b.off"}, "", "<a.xyz");
  CHECK(run.status == 0);
  CHECK(testing::mesh_of_off(dir.path() / "b.off").points.size() == 4);
  dir.file("broken.xyz", "0 0 0\n0 0\n");
  const Run broken = testing::run(dir, {"--input-format=xyz", "-", "b.off"}, "", "<broken.xyz");
  CHECK(broken.status == 2);
  CHECK(broken.err.starts_with("tetsculpt: standard input:2: "));
  const Run none = testing::run(dir, {"--input-format=xyz", "-", "b.off"}, "", "</dev/null");
  CHECK(none.status == 3);
  CHECK(none.err == "tetsculpt: standard input: no points; a solid needs at least 4\n");
}

void check_usage(const std::vector<std::string>& words, const std::string& message) {
  const TempDir dir;
  const Run run = testing::run(dir, words);
  CHECK(run.status == 1);
  CHECK(run.out.empty());
  CHECK(run.err == "tetsculpt: " + message + " ('tetsculpt --help' explains)\n");
  CHECK(testing::names_in(dir).empty());
}

TEST_CASE("a typo has a suggestion, where one is near") {
  for (const auto& [word, meant] :
       {std::pair{"--treads", "--threads"}, std::pair{"--htreads=2", "--threads"},
        std::pair{"--crit", "--criterion"}, std::pair{"-method", "--method"},
        std::pair{"-output=a", "--output"}, std::pair{"--quite", "--quiet"}}) {
    const std::string given = std::string(word).substr(0, std::string(word).find('='));
    check_usage({word, "a.xyz", "b.ply"},
                "unknown option '" + given + "'; did you mean " + meant + "?");
  }
  check_usage({"--zzzzzz", "a.xyz", "b.ply"}, "unknown option '--zzzzzz'");
  check_usage({"-qz", "a.xyz", "b.ply"}, "unknown option '-qz'");
  check_usage({"--method=papr", "a.xyz", "b.ply"},
              "--method: 'papr' is none of guided, paper; did you mean paper?");
  check_usage({"--up", "v", "a.xyz", "b.ply"}, "--up: 'v' is none of x, y, z");
}

TEST_CASE("a typo in an extension") {
  const TempDir dir;
  const Run run = testing::run(dir, {"a.xyz", "b.pyl"});
  CHECK(run.status == 1);
  CHECK(run.err.find("b.pyl: unknown kind of output file; use .ply, ") != std::string::npos);
  CHECK(run.err.find("; did you mean .ply? ") != std::string::npos);
}

TEST_CASE("a typo in check or info, and in their options") {
  const std::string check = "there is no file 'chekc'; did you mean check?";
  check_usage({"chekc", "x"}, check);
  check_usage({"chekc", "x.ply"}, check);
  check_usage({"chekc", "--json", "x.ply"}, check);
  check_usage({"inof", "x.xyz"}, "there is no file 'inof'; did you mean info?");
  const TempDir dir;
  const auto told = [&dir](const std::vector<std::string>& words) {
    const std::string err = testing::run(dir, words).err;
    return err.substr(0, err.find(" ('"));
  };
  CHECK(told({"check", "--wed", "x.ply"}) ==
        "tetsculpt: unknown option '--wed'; did you mean --weld?");
  CHECK(told({"info", "--jsn", "x.xyz"}) ==
        "tetsculpt: unknown option '--jsn'; did you mean --json?");
  CHECK(told({"info", "--points", "x.xyz"}) == "tetsculpt: unknown option '--points'");
  dir.file("inof", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  CHECK(testing::run(dir, {"inof", "b.ply"}).status == 0);  // it is a file
  CHECK(testing::run(dir, {"chek.xyz", "b.ply"}).status == 2);
}

TEST_CASE("what excludes what") {
  check_usage({"-qv", "a.xyz", "b.ply"}, "--quiet and --verbose contradict each other");
  check_usage({"-q", "--progress", "a.xyz", "b.ply"},
              "--quiet and --progress contradict each other");
  check_usage({"a.xyz", "-"}, "standard output needs --output-format");
  check_usage({"a.xyz", "-", "--output-format=ply", "--stats"},
              "standard output takes the surface or the statistics; use --stats=FILE");
  check_usage({"-n", "--stats", "a.xyz"}, "--stats with --dry-run, which computes nothing");
  check_usage({"-i", "a.xyz", "-i", "b.xyz", "c.ply"}, "--input is given twice");
  check_usage({"-i", "a.xyz", "b.ply", "c.ply"}, "unexpected word 'c.ply'");
  check_usage({"a.xyz", "b.ply", "-o"}, "-o needs a value");
  check_usage({"a.xyz", "b.ply", "--tetrahedra", "t.ply"},
              "t.ply: unknown kind of tetrahedra file; use .vtk or .mesh");
}

}  // namespace
}  // namespace tetsculpt
