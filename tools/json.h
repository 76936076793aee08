#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

/// As much of JSON as the command writes.
namespace tetsculpt::cli {

/// `text` as a JSON string, quotes included. Bytes are taken to be UTF-8.
inline std::string json_string(std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20) {
      quoted.append("\\u00").append(1, kHex[code >> 4]).append(1, kHex[code & 15]);
      continue;
    }
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

/// The shortest text that reads back as the same double; null for what JSON has no number for.
inline std::string json_number(double value) {
  if (!std::isfinite(value)) return "null";
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

/// Writes the members of one JSON object in the order they are added.
class JsonObject {
 public:
  void add(std::string_view key, std::size_t value) { add_raw(key, std::to_string(value)); }
  void add(std::string_view key, bool value) { add_raw(key, value ? "true" : "false"); }
  void add(std::string_view key, const std::string& value) { add_raw(key, json_string(value)); }
  void add(std::string_view key, const char* value) { add_raw(key, json_string(value)); }
  void add(std::string_view key, double seconds) {
    char digits[32];
    const auto end =
        std::to_chars(digits, digits + sizeof digits, seconds, std::chars_format::fixed, 6);
    add_raw(key, std::string_view(digits, end.ptr));
  }
  void add(std::string_view key, const JsonObject& object) { add_raw(key, object.text()); }
  /// `json` is a value already.
  void add_raw(std::string_view key, std::string_view json) {
    if (!members_.empty()) members_ += ", ";
    members_.append("\"").append(key).append("\": ").append(json);
  }
  std::string text() const { return '{' + members_ + '}'; }

 private:
  std::string members_;
};

/// Writes the items of one JSON array.
class JsonArray {
 public:
  void add_raw(std::string_view json) {
    if (!items_.empty()) items_ += ", ";
    items_ += json;
  }
  std::string text() const { return '[' + items_ + ']'; }

 private:
  std::string items_;
};

}  // namespace tetsculpt::cli
