#include "io/json_value.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <iterator>
#include <system_error>
#include <utility>

#include "io/parse_number.h"

namespace tetsculpt {
namespace {

constexpr int kDeepest = 200;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

void append_utf8(std::string& text, std::uint32_t code) {
  const auto add = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80) return add(code);
  if (code < 0x800) {
    add(0xC0 | code >> 6);
  } else if (code < 0x10000) {
    add(0xE0 | code >> 12);
    add(0x80 | (code >> 6 & 0x3F));
  } else {
    add(0xF0 | code >> 18);
    add(0x80 | (code >> 12 & 0x3F));
    add(0x80 | (code >> 6 & 0x3F));
  }
  add(0x80 | (code & 0x3F));
}

class JsonParser {
 public:
  explicit JsonParser(std::string_view text) : text_(text) {}

  JsonValue parse() {
    JsonValue value = parse_value(0);
    skip_blanks();
    if (at_ < text_.size()) fail("text behind the JSON value");
    return value;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw JsonError(at_, reason); }

  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  void skip_blanks() {
    constexpr std::string_view kBlanks = " \t\r\n";
    while (at_ < text_.size() && kBlanks.find(text_[at_]) != std::string_view::npos) ++at_;
  }

  bool accept(char c) {
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  void expect(char c, const std::string& where) {
    if (!accept(c)) fail(std::string("expected ") + c + " in " + where);
  }

  JsonValue parse_value(int depth) {
    if (depth > kDeepest) fail("values nested deeper than " + std::to_string(kDeepest));
    skip_blanks();
    JsonValue result{.value = nullptr, .offset = at_};
    switch (peek()) {
      case '{':
        result.value = parse_object(depth);
        break;
      case '[':
        result.value = parse_list(depth);
        break;
      case '"':
        result.value = parse_text();
        break;
      case 't':
        expect_word("true");
        result.value = true;
        break;
      case 'f':
        expect_word("false");
        result.value = false;
        break;
      case 'n':
        expect_word("null");
        break;
      default:
        result.value = parse_number();
    }
    return result;
  }

  JsonValue::Object parse_object(int depth) {
    JsonValue::Object members;
    ++at_;
    if (accept('}')) return members;
    do {
      skip_blanks();
      if (peek() != '"') fail("expected the name of a member");
      std::string name = parse_text();
      expect(':', "an object");
      members.push_back({std::move(name), parse_value(depth + 1)});
    } while (accept(','));
    expect('}', "an object");
    std::ranges::stable_sort(members, {}, &JsonMember::name);
    const auto twice = std::ranges::adjacent_find(members, {}, &JsonMember::name);
    if (twice != members.end()) {
      throw JsonError(std::next(twice)->value.offset, "the member " + twice->name + " again");
    }
    return members;
  }

  JsonValue::List parse_list(int depth) {
    JsonValue::List items;
    ++at_;
    if (accept(']')) return items;
    do items.push_back(parse_value(depth + 1));
    while (accept(','));
    expect(']', "a list");
    return items;
  }

  void expect_word(std::string_view word) {
    if (!text_.substr(at_).starts_with(word)) fail("expected a JSON value");
    at_ += word.size();
  }

  void skip_digits() {
    if (!is_digit(peek())) fail("expected a digit");
    while (is_digit(peek())) ++at_;
  }

  double parse_number() {
    const std::size_t begin = at_;
    if (peek() == '-') ++at_;
    if (!is_digit(peek())) fail(at_ == text_.size() ? "the text ends early" : "expected a value");
    if (peek() == '0') {
      ++at_;
    } else {
      skip_digits();
    }
    if (peek() == '.') {
      ++at_;
      skip_digits();
    }
    if (peek() == 'e' || peek() == 'E') {
      ++at_;
      if (peek() == '+' || peek() == '-') ++at_;
      skip_digits();
    }
    const auto parsed = tetsculpt::parse_number<double>(text_.substr(begin, at_ - begin));
    if (parsed.fault != NumberFault::kNone) throw JsonError(begin, "number out of range");
    return parsed.value;
  }

  std::string parse_text() {
    constexpr auto kPlain = [](char c) {
      return c != '"' && c != '\\' && static_cast<unsigned char>(c) >= 0x20;
    };
    std::string text;
    ++at_;
    for (;;) {
      const std::size_t begin = at_;
      while (at_ < text_.size() && kPlain(text_[at_])) ++at_;
      text.append(text_, begin, at_ - begin);
      if (at_ == text_.size()) fail("a text without its end");
      const char c = text_[at_];
      if (c != '"' && c != '\\') fail("a control character in a text");
      ++at_;
      if (c == '"') return text;
      parse_escape(text);
    }
  }

  void parse_escape(std::string& text) {
    constexpr std::string_view kEscapes = "\"\\/bfnrt";
    constexpr std::string_view kMeanings = "\"\\/\b\f\n\r\t";
    const char c = peek();
    const std::size_t known = at_ < text_.size() ? kEscapes.find(c) : std::string_view::npos;
    if (known != std::string_view::npos) {
      text += kMeanings[known];
      ++at_;
    } else if (c == 'u') {
      append_utf8(text, parse_code());
    } else {
      fail("an unknown escape in a text");
    }
  }

  // From the u on; of a surrogate pair both.
  std::uint32_t parse_code() {
    const std::uint32_t first = parse_unit();
    if (first < 0xD800 || first > 0xDFFF) return first;
    if (first > 0xDBFF || !text_.substr(at_).starts_with("\\u")) fail("half a surrogate pair");
    ++at_;
    const std::uint32_t second = parse_unit();
    if (second < 0xDC00 || second > 0xDFFF) fail("half a surrogate pair");
    return 0x10000 + ((first - 0xD800) << 10) + (second - 0xDC00);
  }

  std::uint32_t parse_unit() {
    constexpr std::size_t kDigits = 4;
    const std::string_view digits = text_.substr(at_ + 1, kDigits);
    std::uint32_t unit = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), unit, 16);
    if (error != std::errc() || end != digits.data() + kDigits) {
      fail("an escape needs four hexadecimal digits");
    }
    at_ += 1 + kDigits;
    return unit;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

const JsonValue* JsonValue::member(std::string_view name) const {
  const auto* const members = as<Object>();
  if (members == nullptr) return nullptr;
  const auto found = std::ranges::lower_bound(*members, name, {}, &JsonMember::name);
  return found != members->end() && found->name == name ? &found->value : nullptr;
}

JsonValue parse_json(std::string_view text) { return JsonParser(text).parse(); }

}  // namespace tetsculpt
