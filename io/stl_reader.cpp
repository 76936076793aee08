// The STL format of 3D Systems: text, or 80 free bytes, the number of triangles and 50 bytes for
// each, little endian.
#include "io/stl_reader.h"

#include <array>
#include <bit>
#include <cstdint>
#include <string>

#include "io/binary_columns.h"
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

// The tokens of an ascii file, over its lines.
class StlText {
 public:
  StlText(std::string_view text, const std::filesystem::path& path) : in_(text, path, kDialect) {}

  PointFile parse() && {
    next_token_line();
    do {
      expect("solid");
      in_.next_line();  // what is behind is a name
      while (next_token_line() && !accept("endsolid")) facet();
      if (!closed_) in_.fail("the file ends without endsolid");
      closed_ = false;
      in_.next_line();
    } while (next_token_line());
    return std::move(file_);
  }

 private:
  bool next_token_line() { return !in_.at_line_end() || in_.next_content_line(); }

  bool accept(std::string_view word) {
    TextScanner look = in_;
    if (!is_word(look.token(), word)) return false;
    in_ = look;
    return true;
  }

  TextScanner in_;
  PointFile file_;
  bool closed_ = false;
};

}  // namespace
}  // namespace tetsculpt
