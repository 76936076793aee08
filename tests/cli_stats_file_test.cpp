// --stats=FILE writes the object that --stats prints, whole or not at all.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/support/sculpt_cli.h"
#include "tests/support/sculpt_json.h"

namespace tetsculpt {
namespace {

using testing::Run;
using testing::TempDir;

constexpr const char* kTetrahedron = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

testing::JsonMembers members(const std::string& text) { return testing::JsonReader(text).read(); }

TEST_CASE("the same members in a file, and nothing on stdout") {
  const TempDir dir;
  dir.file("a.xyz", kTetrahedron);
  const Run file = testing::run(dir, {"--stats=s.json", "a.xyz", "b.ply"});
  CHECK(file.status == 0);
  CHECK(file.out.empty());
  auto in_file = members(testing::bytes_of(dir.path() / "s.json"));
  for (const char* word : {"--stats", "--stats=-"}) {
    auto printed = members(testing::run(dir, {word, "a.xyz", "b.ply"}).out);
    CHECK(printed.size() == in_file.size());
    CHECK(printed["version"] == "\"" TETSCULPT_VERSION "\"");
    for (const auto& member : in_file) {
      INFO(member.first);
      if (!member.first.starts_with("seconds")) CHECK(printed[member.first] == member.second);
    }
  }
}

TEST_CASE("a file that can't be made is found before the work") {
  const TempDir dir;
  dir.file("a.xyz", kTetrahedron);
  const Run run = testing::run(dir, {"--stats=none/s.json", "a.xyz", "b.ply"});
  CHECK(run.status == 5);
  CHECK(run.err.starts_with("tetsculpt: none/s.json: cannot create: "));
  CHECK(testing::names_in(dir) == std::vector<std::string>{"a.xyz"});
}

TEST_CASE("no surface, no statistics: an old file stays") {
  const TempDir dir;
  dir.file("a.xyz", "0 0 0\n1 0 0\n0 1 0\n");
  dir.file("s.json", "as it was");
  CHECK(testing::run(dir, {"--stats=s.json", "a.xyz", "b.ply"}).status == 3);
  CHECK(testing::bytes_of(dir.path() / "s.json") == "as it was");
  CHECK(testing::names_in(dir) == std::vector<std::string>{"a.xyz", "s.json"});
}

}  // namespace
}  // namespace tetsculpt
