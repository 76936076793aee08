#include "io/obj_mesh.h"

#include <charconv>
#include <cstdint>
#include <limits>
#include <string>
#include <system_error>

#include "io/io_error.h"
#include "io/polygon_fan.h"
#include "io/text_scanner.h"

namespace tetsculpt {
namespace {

class ObjParser {
 public:
  ObjParser(std::string_view text, const std::filesystem::path& path)
      : path_(path), in_(text, path, kDialect), fan_(file_.mesh.triangles) {}

  MeshFile parse() && {
    while (in_.next_line()) {
      const std::string_view keyword = in_.token();
      if (keyword == "v") file_.mesh.points.push_back(in_.point());
      if (keyword == "f") parse_face();
    }
    // A face may come before its vertices.
    if (highest_ > file_.mesh.points.size()) {
      throw IoError(path_, LineNumber{line_of_highest_}, fault_of(highest_));
    }
    return std::move(file_);
  }

 private:
  static constexpr TextDialect kDialect{};
  // Indices are 32 bits wide.
  static constexpr std::int64_t kMost = std::numeric_limits<std::uint32_t>::max();

  void parse_face() {
    while (!in_.at_line_end()) fan_.add(parse_corner(in_.token()));
    if (const auto fault = fan_.finish()) in_.fail(*fault);
  }

  std::uint32_t parse_corner(std::string_view token) {
    std::int64_t index = 0;
    const char* const end = token.data() + token.size();
    const auto [after, error] = std::from_chars(token.data(), end, index);
    if (error != std::errc() || (after != end && *after != '/')) {
      in_.fail("a corner of a face must begin with an index");
    }
    const auto vertices = static_cast<std::int64_t>(file_.mesh.points.size());
    const bool backwards = index < 0;
    if (index == 0 || index > kMost || index < -vertices) in_.fail(fault_of(index));
    if (backwards) index += vertices + 1;
    if (static_cast<std::uint64_t>(index) > highest_) {
      highest_ = static_cast<std::uint64_t>(index);
      line_of_highest_ = in_.line_number();
    }
    return static_cast<std::uint32_t>(index - 1);
  }

  template <typename Index>
  std::string fault_of(Index index) const {
    return no_such_vertex(std::to_string(index), file_.mesh.points.size());
  }

  const std::filesystem::path& path_;
  TextScanner in_;
  MeshFile file_;
  PolygonFan fan_;
  std::uint64_t highest_ = 0;  // index of all faces, counted from 1
  std::uint64_t line_of_highest_ = 0;
};

}  // namespace

MeshFile parse_obj_mesh(std::string_view text, const std::filesystem::path& path) {
  return ObjParser(text, path).parse();
}

}  // namespace tetsculpt
