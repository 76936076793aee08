// The completion, sourced in bash: options, values and files.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/sculpt_cli.h"

namespace tetsculpt {
namespace {

using testing::TempDir;
using Words = std::vector<std::string>;

bool bash_is_there() { return std::system("command -v bash >/dev/null") == 0; }

/// What bash would offer for the last of these words, ascending.
Words offers(const TempDir& dir, const Words& words) {
  const TempDir scripts;
  scripts.file("completion", testing::run(dir, {"--print-completion"}).out);
  std::string script = "source '" + (scripts.path() / "completion").string() + "'\nCOMP_WORDS=(";
  for (const std::string& word : words) script += "'" + word + "' ";
  script += ")\nCOMP_CWORD=" + std::to_string(words.size() - 1) +
            "\n_tetsculpt\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
  const std::string file = scripts.file("script", script).string();
  const std::string out = (scripts.path() / "out").string();
  REQUIRE(std::system(
              ("cd '" + dir.path().string() + "' && bash --norc '" + file + "' >'" + out + "' 2>&1")
                  .c_str()) == 0);
  std::istringstream lines(testing::bytes_of(out));
  Words offered;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) offered.push_back(line);
  }
  std::ranges::sort(offered);
  return offered;
}

TEST_CASE("options") {
  if (!bash_is_there()) return;
  const TempDir dir;
  CHECK(offers(dir, {"tetsculpt", "--me"}) == Words{"--method"});
  CHECK(offers(dir, {"tetsculpt", "a.xyz", "--inp"}) == Words{"--input", "--input-format"});
  const std::string help = testing::run(dir, {"--help"}).out;
  const Words all = offers(dir, {"tetsculpt", "--"});
  CHECK(all.size() > 15);
  for (const std::string& option : all) CHECK(help.find(option) != std::string::npos);
}

TEST_CASE("values, after a space or an equals sign") {
  if (!bash_is_there()) return;
  const TempDir dir;
  CHECK(offers(dir, {"tetsculpt", "--method", ""}) == Words{"guided", "paper"});
  CHECK(offers(dir, {"tetsculpt", "--method", "=", "pa"}) == Words{"paper"});
  CHECK(offers(dir, {"tetsculpt", "--method", "="}) == Words{"guided", "paper"});
  CHECK(offers(dir, {"tetsculpt", "--up", ""}) == Words{"x", "y", "z"});
  CHECK(offers(dir, {"tetsculpt", "--threads", ""}).empty());
  const Words formats = offers(dir, {"tetsculpt", "--output-format", ""});
  CHECK(std::ranges::count(formats, "ply") == 1);
}

TEST_CASE("files, with spaces in their names too") {
  if (!bash_is_there()) return;
  const TempDir dir;
  for (const char* name : {"scan.xyz", "scan two.ply", "other"}) dir.file(name, "");
  const Words scans{"scan two.ply", "scan.xyz"};
  CHECK(offers(dir, {"tetsculpt", "scan"}) == scans);
  CHECK(offers(dir, {"tetsculpt", "--input", "scan"}) == scans);
  CHECK(offers(dir, {"tetsculpt", "--stats", "=", "scan"}) == scans);
  CHECK(offers(dir, {"tetsculpt", "--stats", "scan"}) == scans);
  CHECK(offers(dir, {"tetsculpt", "-q", "scan.xyz", "o"}) == Words{"other"});
  CHECK(offers(dir, {"tetsculpt", "c"}) == Words{"check"});
}

}  // namespace
}  // namespace tetsculpt
