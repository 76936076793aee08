#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tetsculpt {

/// The line of a text, counted from 1, on which the byte at `offset` is. Lines end with LF, CRLF or
/// CR.  Cost: linear.
inline std::uint64_t line_of(std::string_view text, std::size_t offset) {
  std::uint64_t line = 1;
  for (std::size_t i = 0; i < offset; ++i) {
    line += text[i] == '\n' || (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n'));
  }
  return line;
}

}  // namespace tetsculpt
