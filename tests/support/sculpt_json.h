#pragma once

#include <algorithm>
#include <cctype>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

/// As much of JSON as the command line writes.
namespace tetsculpt::testing {

using JsonMembers = std::map<std::string, std::string>;

/// Reads objects of numbers, words, truth values, objects and arrays. Members of an inner object
/// are named outer.inner, items of an array outer[0]; a member that occurs twice, or a thing that
/// is no JSON, is an exception.
class JsonReader {
 public:
  explicit JsonReader(std::string_view text) : text_(text) {}

  JsonMembers read() {
    read_object("");
    skip_blanks();
    if (!text_.empty()) throw std::runtime_error("text after the object");
    return members_;
  }

 private:
  void read_object(const std::string& prefix) {
    expect('{');
    if (take('}')) return;
    do {
      const std::string name = prefix + read_word();
      expect(':');
      read_value(name);
    } while (take(','));
    expect('}');
  }

  void read_array(const std::string& name) {
    expect('[');
    if (take(']')) return;
    std::size_t count = 0;
    do {
      read_value(name + '[' + std::to_string(count++) + ']');
    } while (take(','));
    expect(']');
  }

  void read_value(const std::string& name) {
    skip_blanks();
    std::string value;
    if (text_.starts_with('{')) {
      value = "object";
      read_object(name + ".");
    } else if (text_.starts_with('[')) {
      value = "array";
      read_array(name);
    } else if (text_.starts_with('"')) {
      value = '"' + read_word() + '"';
    } else {
      const auto end = std::ranges::find_if_not(text_, [](unsigned char c) {
        return std::isalnum(c) || c == '.' || c == '-' || c == '+';
      });
      value = std::string(text_.begin(), end);
      text_.remove_prefix(value.size());
    }
    if (value.empty() || !members_.emplace(name, value).second) throw std::runtime_error(name);
  }

  std::string read_word() {
    expect('"');
    std::string word;
    while (!text_.starts_with('"')) {
      if (text_.starts_with('\\')) text_.remove_prefix(1);  // before '"' and itself alone
      if (text_.empty()) throw std::runtime_error("no end of a word");
      word += text_.front();
      text_.remove_prefix(1);
    }
    text_.remove_prefix(1);
    return word;
  }

  void skip_blanks() {
    while (text_.starts_with(' ') || text_.starts_with('\n')) text_.remove_prefix(1);
  }
  bool take(char c) {
    skip_blanks();
    if (!text_.starts_with(c)) return false;
    text_.remove_prefix(1);
    return true;
  }
  void expect(char c) {
    if (!take(c)) throw std::runtime_error(std::string("no ") + c);
  }

  std::string_view text_;
  JsonMembers members_;
};

}  // namespace tetsculpt::testing
