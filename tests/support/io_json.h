#pragma once

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "io/parse_number.h"

/// JSON, strictly: what is none is an exception.
namespace tetsculpt::testing {

struct Json {
  enum class Kind { kWord, kNumber, kText, kList, kObject };
  Kind kind = Kind::kWord;
  std::string text;  ///< of a text, of a number as it stands, or true, false, null
  std::vector<Json> items;
  std::map<std::string, Json> members;

  const Json& operator[](const std::string& name) const { return members.at(name); }
  const Json& operator[](std::size_t i) const { return items.at(i); }
  bool has(const std::string& name) const { return members.contains(name); }
  double number() const {
    if (kind != Kind::kNumber) throw std::runtime_error("no number: " + text);
    return parse_number<double>(text).value;
  }
  std::size_t size() const { return static_cast<std::size_t>(number()); }
};

class JsonParser {
 public:
  explicit JsonParser(std::string_view text) : rest_(text) {}

  Json parse() {
    Json value = read_value();
    skip_blanks();
    if (!rest_.empty()) throw std::runtime_error("text after the value");
    return value;
  }

 private:
  Json read_value() {
    skip_blanks();
    if (rest_.starts_with('{')) return read_object();
    if (rest_.starts_with('[')) return read_list();
    if (rest_.starts_with('"')) return {Json::Kind::kText, read_text(), {}, {}};
    for (const std::string_view word : {"true", "false", "null"}) {
      if (!rest_.starts_with(word)) continue;
      rest_.remove_prefix(word.size());
      return {Json::Kind::kWord, std::string(word), {}, {}};
    }
    return read_number();
  }

  Json read_number() {
    const std::string_view digits = rest_.substr(rest_.starts_with('-') ? 1 : 0);
    const ParsedNumber<double> parsed = parse_number<double>(rest_);
    const bool starts_well = !digits.empty() && digits[0] >= '0' && digits[0] <= '9';
    if (!starts_well || parsed.fault != NumberFault::kNone) throw std::runtime_error("no value");
    const auto size = static_cast<std::size_t>(parsed.end - rest_.data());
    Json value{Json::Kind::kNumber, std::string(rest_.substr(0, size)), {}, {}};
    rest_.remove_prefix(size);
    return value;
  }

  Json read_list() {
    Json value{Json::Kind::kList, "", {}, {}};
    expect('[');
    if (take(']')) return value;
    do value.items.push_back(read_value());
    while (take(','));
    expect(']');
    return value;
  }

  Json read_object() {
    Json value{Json::Kind::kObject, "", {}, {}};
    expect('{');
    if (take('}')) return value;
    do {
      skip_blanks();
      const std::string name = read_text();
      expect(':');
      if (!value.members.emplace(name, read_value()).second) throw std::runtime_error(name);
    } while (take(','));
    expect('}');
    return value;
  }

  std::string read_text() {
    std::string text;
    expect('"');
    while (!rest_.empty() && rest_[0] != '"') {
      if (rest_[0] == '\\') rest_.remove_prefix(1);  // only quotes and backslashes are escaped
      text += rest_.at(0);
      rest_.remove_prefix(1);
    }
    expect('"');
    return text;
  }

  void skip_blanks() {
    while (rest_.starts_with(' ') || rest_.starts_with('\n')) rest_.remove_prefix(1);
  }
  bool take(char c) {
    skip_blanks();
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void expect(char c) {
    if (!take(c)) throw std::runtime_error(std::string("no ") + c);
  }

  std::string_view rest_;
};

}  // namespace tetsculpt::testing
