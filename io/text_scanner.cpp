#include "io/text_scanner.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <string>
#include <system_error>

#include "io/io_error.h"
#include "io/parse_number.h"
#include "io/quoted.h"

namespace tetsculpt {
TextScanner::TextScanner(std::string_view text, const std::filesystem::path& path,
                         const TextDialect& dialect)
    : text_(text), path_(path), dialect_(dialect) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text_.starts_with(kByteOrderMark)) next_ = line_feed_ = kByteOrderMark.size();
  for (const char c : dialect.separators) {
    kinds_[static_cast<unsigned char>(c)] = Kind::kSeparator;
  }
  for (const char c : dialect.delimiters) {
    kinds_[static_cast<unsigned char>(c)] = Kind::kDelimiter;
  }
}

bool TextScanner::next_line() {
  if (next_ >= text_.size()) return false;
  // The line feed is kept over the lines, or a text of CR lines would cost quadratic time.
  if (line_feed_ < next_ || line_number_ == 0) {
    line_feed_ = std::min(text_.find('\n', next_), text_.size());
  }
  rest_ = text_.substr(next_, line_feed_ - next_);
  rest_ = rest_.substr(0, rest_.find('\r'));
  next_ += rest_.size();
  if (next_ < text_.size() && text_[next_] == '\r') ++next_;
  if (next_ < text_.size() && text_[next_] == '\n') ++next_;
  ++line_number_;
  return true;
}

bool TextScanner::next_content_line() {
  while (next_line()) {
    if (!at_line_end()) return true;
  }
  return false;
}

std::string_view TextScanner::take_bytes(std::size_t size) {
  assert(size <= bytes_left());
  const std::string_view bytes = text_.substr(next_, size);
  next_ += size;
  rest_ = text_.substr(next_, 0);
  behind_bytes_ = true;
  return bytes;
}

void TextScanner::skip_separators() {
  std::size_t i = 0;
  while (i < rest_.size() && kind(rest_[i]) == Kind::kSeparator) ++i;
  rest_.remove_prefix(i);
}

bool TextScanner::at_line_end() {
  skip_separators();
  return rest_.empty() || std::ranges::any_of(dialect_.comments, [this](std::string_view start) {
           return !start.empty() && rest_.starts_with(start);
         });
}

bool TextScanner::at_delimiter() {
  skip_separators();
  return !rest_.empty() && kind(rest_.front()) == Kind::kDelimiter;
}

bool TextScanner::at_number() {
  skip_separators();
  const auto parsed = parse_number<double>(rest_);
  const char* const end = rest_.data() + rest_.size();
  return parsed.fault != NumberFault::kNotANumber &&
         (parsed.end == end || kind(*parsed.end) != Kind::kOfToken);
}

std::string_view TextScanner::token() {
  skip_separators();
  std::size_t i = 0;
  if (!dialect_.delimiters.empty() && rest_.starts_with('"')) {
    i = std::min(rest_.find('"', 1), rest_.size());
  }
  while (i < rest_.size() && kind(rest_[i]) == Kind::kOfToken) ++i;
  const std::string_view token = rest_.substr(0, i);
  rest_.remove_prefix(i);
  return token;
}

template <typename Float>
std::optional<Float> TextScanner::number_or_nothing() {
  skip_separators();
  const auto parsed = parse_number<Float>(rest_);
  const char* const end = rest_.data() + rest_.size();
  if (parsed.fault == NumberFault::kNotANumber ||
      (parsed.end != end && kind(*parsed.end) == Kind::kOfToken)) {
    return std::nullopt;
  }
  if (parsed.fault == NumberFault::kTooLarge) fail_at_token("number out of range: ");
  rest_.remove_prefix(static_cast<std::size_t>(parsed.end - rest_.data()));
  return parsed.value;
}

template <typename Float>
Float TextScanner::number() {
  const std::optional<Float> value = number_or_nothing<Float>();
  if (!value) fail_at_token("expected a number, found ");
  return *value;
}

template float TextScanner::number<float>();
template double TextScanner::number<double>();

std::optional<double> TextScanner::number_if_any() { return number_or_nothing<double>(); }

template <typename Integer>
Integer TextScanner::whole_number(std::string_view expected) {
  skip_separators();
  const char* const end = rest_.data() + rest_.size();
  Integer value = 0;
  const auto [after, error] = std::from_chars(rest_.data(), end, value);
  if (error != std::errc() || (after != end && kind(*after) == Kind::kOfToken)) {
    fail_at_token(expected);
  }
  rest_.remove_prefix(static_cast<std::size_t>(after - rest_.data()));
  return value;
}

std::uint64_t TextScanner::count() {
  return whole_number<std::uint64_t>("expected a count, found ");
}

std::int64_t TextScanner::integer() {
  return whole_number<std::int64_t>("expected an integer, found ");
}

Point3 TextScanner::point() {
  const auto x = number<double>();
  const auto y = number<double>();
  const auto z = number<double>();
  return {x, y, z};
}

std::string_view TextScanner::next_cell() {
  const std::string_view before = rest_;
  if (at_delimiter()) rest_.remove_prefix(1);
  return before.substr(0, before.size() - rest_.size());
}

bool TextScanner::accept(std::string_view word) {
  skip_separators();
  if (!rest_.starts_with(word)) return false;
  rest_.remove_prefix(word.size());
  return true;
}

void TextScanner::fail(std::string_view reason) const {
  if (behind_bytes_) {
    const auto at = static_cast<std::uint64_t>(rest_.data() - text_.data());
    throw IoError(path_, ByteOffset{at}, reason);
  }
  throw IoError(path_, LineNumber{std::max<std::uint64_t>(line_number_, 1)}, reason);
}

void TextScanner::fail_at_token(std::string_view reason) {
  if (at_line_end()) fail(std::string(reason) + "the end of the line");
  const std::string_view found = token();
  fail(std::string(reason) + (found.empty() ? "an empty cell" : quoted(found)));
}

}  // namespace tetsculpt
