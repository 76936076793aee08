#pragma once

#include <string>
#include <string_view>

namespace tetsculpt {

/// A word of a file for messages: short and printable whatever the file holds.
inline std::string quoted(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text = "'";
  for (const char c : word.substr(0, kLongest)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > kLongest ? "...'" : "'");
}

}  // namespace tetsculpt
