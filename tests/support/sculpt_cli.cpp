#include "tests/support/sculpt_cli.h"

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <fstream>

#include "io/read_points.h"

namespace tetsculpt::testing {
namespace {

std::string shell_word(std::string_view word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace

Run run(const TempDir& dir, const std::vector<std::string>& words, std::string_view before,
        std::string_view redirection) {
  const TempDir streams;
  const std::filesystem::path out = streams.path() / "out";
  const std::filesystem::path err = streams.path() / "err";
  std::string command = "cd " + shell_word(dir.path().string()) + " && ";
  command.append(before).append(" ").append(shell_word(TETSCULPT_CLI));
  for (const std::string& word : words) command.append(" ").append(shell_word(word));
  command.append(" >")
      .append(shell_word(out.string()))
      .append(" 2>")
      .append(shell_word(err.string()));
  command.append(" ").append(redirection);
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes_of(out), bytes_of(err)};
}

std::vector<std::string> names_in(const TempDir& dir) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(dir.path())) {
    names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}

std::string xyz(const std::vector<Point3>& points) {
  std::string text;
  for (const Point3& p : points) {
    for (const double x : {p.x, p.y, p.z}) {
      char digits[64];
      text.append(digits, std::to_chars(digits, digits + sizeof digits, x).ptr).append(" ");
    }
    text.back() = '\n';
  }
  return text;
}

TriangleMesh mesh_of_off(const std::filesystem::path& path) {
  TriangleMesh mesh{read_points(path).points, {}};
  std::ifstream in(path);
  std::string line;
  while (std::getline(in, line)) {
    // Only a row of a triangle begins with "3 " and has four numbers without a fraction; rows of
    // points have three numbers, and they come first.
    if (std::ranges::count(line, ' ') != 3 || !line.starts_with("3 ")) continue;
    std::array<std::uint32_t, 3> corners{};
    const char* at = line.data() + 1;
    for (std::uint32_t& corner : corners) {
      at = std::from_chars(at + 1, line.data() + line.size(), corner).ptr;
    }
    mesh.triangles.push_back(corners);
  }
  return mesh;
}

}  // namespace tetsculpt::testing
