// --viewer writes a page, whole or not at all, that shows what the run found.
#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/support/point_sets.h"
#include "tests/support/sculpt_cli.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

using testing::bytes_of;
using testing::Run;
using testing::TempDir;

TEST_CASE("a page with the run's facts, the same at every run, and the same surface as without") {
  const TempDir dir;
  dir.file("a<1>.xyz", testing::xyz(point_sets::ellipsoid(0.3, 1)));
  CHECK(testing::run(dir, {"a<1>.xyz", "plain.ply"}).status == 0);
  for (const std::string method : {"guided", "paper"}) {
    const auto page = [&](std::vector<std::string> words) {
      words.insert(words.end(), {"--method", method, "--viewer=a.html", "a<1>.xyz", "a.ply"});
      CHECK(testing::run(dir, words).status == 0);
      return bytes_of(dir.path() / "a.html");
    };
    const std::string usual = page({});
    CHECK(usual.find("<h1>a&lt;1&gt;.xyz</h1>") != std::string::npos);
    CHECK(usual.find("<dt>Genus</dt><dd>0</dd>") != std::string::npos);
    CHECK(usual.find("<dd>" + method) != std::string::npos);
    CHECK(page({"--threads", "3"}) == usual);
    CHECK(page({"--up", "y"}) != usual);
    if (method == "guided")
      CHECK(bytes_of(dir.path() / "a.ply") == bytes_of(dir.path() / "plain.ply"));
  }
}

TEST_CASE("hidden points are told, and counted") {
  const TempDir dir;
  dir.file("a.xyz", testing::xyz(testing::set_with_hidden_point()));
  const Run run = testing::run(dir, {"--method", "paper", "--viewer", "a.html", "a.xyz", "a.ply"});
  CHECK(run.status == 4);
  CHECK(bytes_of(dir.path() / "a.html").find("\"hidden\": 1}") != std::string::npos);
}

TEST_CASE("wrong usage") {
  const TempDir dir;
  dir.file("a.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  const std::vector<std::pair<std::vector<std::string>, std::string>> lines{
      {{"a.xyz", "b.ply", "--viewer"}, "--viewer needs a value"},
      {{"a.xyz", "b.ply", "--viewer="}, "--viewer needs a file"},
      {{"a.xyz", "b.ply", "--viewer", "b.htm"},
       "b.htm: unknown kind of viewer; use .html; did you mean .html?"}};
  for (const auto& [words, message] : lines) {
    const Run run = testing::run(dir, words);
    CHECK(run.status == 1);
    CHECK(run.err == "tetsculpt: " + message + " ('tetsculpt --help' explains)\n");
  }
  CHECK(testing::names_in(dir) == std::vector<std::string>{"a.xyz"});
}

TEST_CASE("a page that can't be written: status 5, and no trace of it") {
  const TempDir dir;
  dir.file("a.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  const Run lost = testing::run(dir, {"--viewer", "none/a.html", "a.xyz", "a.ply"});
  CHECK(lost.status == 5);
  CHECK(lost.err.starts_with("tetsculpt: none/a.html: cannot create: "));
  dir.file("old.html", "as it was");
  const Run cut =
      testing::run(dir, {"--viewer", "old.html", "a.xyz", "a.ply"}, "trap '' XFSZ; ulimit -f 20;");
  CHECK(cut.status == 5);
  CHECK(bytes_of(dir.path() / "old.html") == "as it was");
  CHECK(testing::names_in(dir) == std::vector<std::string>{"a.ply", "a.xyz", "old.html"});
}

}  // namespace
}  // namespace tetsculpt
