// The STL format of 3D Systems: text, or 80 free bytes, the number of triangles and 50 bytes for
// each, little endian.
#include "io/stl_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <utility>

#include "io/byte_order.h"
#include "io/io_error.h"
#include "io/text_scanner.h"

namespace tetsculpt {
namespace {

constexpr TextDialect kDialect = {.separators = " \t", .comments = {}};
constexpr std::size_t kCountAt = 80;
constexpr std::size_t kTrianglesAt = 84;
constexpr std::size_t kTriangleSize = 50;  // normal, three corners, two bytes
constexpr std::size_t kFloats = 12;        // bytes of a normal or a corner

std::uint32_t announced_triangles(std::string_view content) {
  return load_number<std::uint32_t>(content.data() + kCountAt, std::endian::little);
}

bool is_word(std::string_view token, std::string_view word) {
  if (token.size() != word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (token[i] != word[i] && token[i] != word[i] - 'a' + 'A') return false;
  }
  return true;
}

// The words of an ascii file, however they are spread over lines.
class StlText {
 public:
  StlText(std::string_view text, const std::filesystem::path& path) : in_(text, path, kDialect) {}

  PointFile parse() && {
    while (find_token()) solid();
    return std::move(file_);
  }

 private:
  bool find_token() {
    while (in_.at_line_end()) {
      if (!in_.next_line()) return false;
    }
    return true;
  }

  std::string_view token() {
    if (!find_token()) in_.fail("the file ends within a solid");
    return in_.token();
  }

  void expect(std::string_view word) {
    if (!is_word(token(), word)) in_.fail("expected " + std::string(word));
  }

  void skip_name() {
    while (!in_.at_line_end()) in_.token();
  }

  void solid() {
    expect("solid");
    skip_name();
    for (std::string_view word = token(); !is_word(word, "endsolid"); word = token()) {
      if (!is_word(word, "facet")) in_.fail("expected facet or endsolid");
      facet();
    }
    skip_name();
  }

  void facet() {
    expect("normal");
    for (int i = 0; i < 3; ++i) token();
    expect("outer");
    expect("loop");
    for (int i = 0; i < 3; ++i) vertex();
    expect("endloop");
    expect("endfacet");
  }

  void vertex() {
    expect("vertex");
    std::array<double, 3> xyz{};
    for (double& value : xyz) {
      if (!find_token()) in_.fail("the file ends within a solid");
      value = in_.number<double>();
    }
    file_.points.push_back({xyz[0], xyz[1], xyz[2]});
  }

  TextScanner in_;
  PointFile file_;
};

PointFile parse_binary(std::string_view content) {
  const std::size_t triangles = announced_triangles(content);
  PointFile file;
  file.precision = Precision::kSingle;
  file.points.reserve(3 * triangles);
  const char* triangle = content.data() + kTrianglesAt;
  for (std::size_t i = 0; i < triangles; ++i, triangle += kTriangleSize) {
    for (std::size_t corner = 1; corner <= 3; ++corner) {
      const auto coordinate = [from = triangle + corner * kFloats](std::size_t axis) {
        return double{load_number<float>(from + axis * sizeof(float), std::endian::little)};
      };
      file.points.push_back({coordinate(0), coordinate(1), coordinate(2)});
    }
  }
  return file;
}

std::size_t triangles_with_room(std::string_view content) {
  return (content.size() - kTrianglesAt) / kTriangleSize;
}

// Programs look for `solid` at the very begin; blanks and a byte order mark are seen, too.
std::string_view first_word(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of("\xEF\xBB\xBF \t\r\n"), text.size());
  const std::size_t end = text.find_first_of(" \t\r\n", begin);
  return text.substr(begin, end - begin);
}

}  // namespace

bool is_binary_stl(std::string_view content) {
  return content.size() >= kTrianglesAt &&
         announced_triangles(content) == triangles_with_room(content);
}

bool begins_as_ascii_stl(std::string_view content) {
  const std::string_view word = first_word(content);
  if (!is_word(word, "solid")) return false;
  const std::size_t line_end = content.find_first_of("\r\n");
  if (line_end == std::string_view::npos) return false;
  const std::string_view next = first_word(content.substr(line_end));
  return is_word(next, "facet") || is_word(next, "endsolid");
}

PointFile parse_stl_points(std::string_view content, const std::filesystem::path& path) {
  if (is_binary_stl(content)) return parse_binary(content);
  const bool has_zeros = content.substr(0, kTrianglesAt).find('\0') != std::string_view::npos;
  if (is_word(first_word(content), "solid") && !has_zeros) return StlText(content, path).parse();
  if (content.size() < kTrianglesAt) throw IoError(path, "not an STL file");
  throw IoError(path, ByteOffset{kCountAt},
                "not an STL file, or cut off: triangles announced: " +
                    std::to_string(announced_triangles(content)) +
                    ", room for: " + std::to_string(triangles_with_room(content)));
}

}  // namespace tetsculpt
