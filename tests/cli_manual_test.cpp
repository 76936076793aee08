// The manual names every option, member of the statistics and exit status, and is sound troff.
#include <doctest/doctest.h>

#include <cctype>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/sculpt_cli.h"
#include "tests/support/sculpt_json.h"

namespace tetsculpt {
namespace {

using testing::Run;
using testing::TempDir;

/// The manual without troff's escapes.
std::string plain_manual() {
  const TempDir dir;
  const Run run = testing::run(dir, {"--print-manual"});
  REQUIRE(run.status == 0);
  std::string text;
  for (std::size_t k = 0; k < run.out.size(); ++k) {
    if (run.out[k] != '\\') {
      text += run.out[k];
    } else if (run.out[k + 1] == 'f') {
      k += 2;
    } else {
      text += run.out[++k];
    }
  }
  return text;
}

/// All words of --help that begin with two dashes and a letter.
std::set<std::string> options_in_help() {
  const TempDir dir;
  const std::string help = testing::run(dir, {"--help"}).out;
  std::set<std::string> options;
  for (std::size_t at = help.find("--"); at != std::string::npos; at = help.find("--", at + 2)) {
    std::size_t end = at + 2;
    while (std::isalpha(static_cast<unsigned char>(help[end])) != 0 || help[end] == '-') ++end;
    if (end > at + 2) options.insert(help.substr(at, end - at));
  }
  return options;
}

TEST_CASE("every option, every member, every status") {
  const std::string manual = plain_manual();
  const std::set<std::string> options = options_in_help();
  CHECK(options.size() > 15);
  for (const std::string& option : options) {
    INFO(option);
    CHECK(manual.find(option) != std::string::npos);
  }
  const TempDir dir;
  dir.file("a.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  const std::string stats = testing::run(dir, {"--stats", "a.xyz", "b.ply"}).out;
  for (const auto& member : testing::JsonReader(stats).read()) {
    INFO(member.first);
    const std::string name = member.first.substr(member.first.find('.') + 1);
    CHECK(manual.find(name) != std::string::npos);
    if (name == member.first) CHECK(manual.find("\n" + name + " (") != std::string::npos);
  }
  for (const std::string status : {"0", "1", "2", "3", "4", "5", "130", "143"}) {
    CHECK(manual.find("\n.TP\n" + status + "\n") != std::string::npos);
  }
}

TEST_CASE("no warnings of mandoc or groff, whichever there is") {
  const TempDir dir;
  dir.file("tetsculpt.1", testing::run(dir, {"--print-manual"}).out);
  const std::string in_dir = "cd '" + dir.path().string() + "' && ";
  const auto succeeds = [&](const std::string& command) {
    return std::system((in_dir + command).c_str()) == 0;
  };
  if (succeeds("command -v mandoc >/dev/null")) {
    CHECK(succeeds("mandoc -Tlint -Wwarning tetsculpt.1"));
  } else if (succeeds("command -v groff >/dev/null")) {
    CHECK(succeeds("groff -man -ww -Tutf8 tetsculpt.1 2>warnings >/dev/null"));
    CHECK(testing::bytes_of(dir.path() / "warnings").empty());
  } else {
    MESSAGE("neither mandoc nor groff is there: the manual is not checked");
  }
}

}  // namespace
}  // namespace tetsculpt
