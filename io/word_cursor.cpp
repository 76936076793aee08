#include "io/word_cursor.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <system_error>

#include "io/io_error.h"
#include "io/line_of.h"
#include "io/parse_number.h"
#include "io/quoted.h"

namespace tetsculpt {
WordCursor::WordCursor(std::string_view text, const std::filesystem::path& path,
                       const WordDialect& dialect)
    : text_(text), path_(&path), comment_(dialect.comment) {
  for (const char c : dialect.separators) kind_[static_cast<unsigned char>(c)] = 1;
  for (const char c : dialect.marks) kind_[static_cast<unsigned char>(c)] = 2;
}

void WordCursor::skip_separators() {
  for (; at_ < text_.size(); ++at_) {
    if (comment_ != '\0' && text_[at_] == comment_) {
      at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
      if (at_ == text_.size()) return;
    }
    if (!is_separator(text_[at_])) return;
  }
}

std::string_view WordCursor::word() {
  skip_separators();
  latest_ = at_;
  if (at_ == text_.size()) return {};
  const char first = text_[at_++];
  if (first == '"' && is_mark(first)) {
    for (; at_ < text_.size() && text_[at_] != '"'; ++at_) at_ += text_[at_] == '\\';
    if (at_ >= text_.size()) fail("a quotation without its end");
    ++at_;
  } else if (!is_mark(first)) {
    while (at_ < text_.size() && !is_separator(text_[at_]) && !is_mark(text_[at_])) ++at_;
  }
  return text_.substr(latest_, at_ - latest_);
}

std::string_view WordCursor::peek() {
  const std::size_t at = at_;
  const std::size_t latest = latest_;
  const std::string_view next = word();
  at_ = at;
  latest_ = latest;
  return next;
}

void WordCursor::fail_at(std::string_view expected, std::string_view word) const {
  fail(std::string(expected) + (word.empty() ? "the end of the file" : quoted(word)));
}

double WordCursor::number() {
  const std::string_view text = word();
  const auto parsed = parse_number<double>(text);
  if (parsed.fault == NumberFault::kNotANumber || parsed.end != text.data() + text.size()) {
    fail_at("expected a number, found ", text);
  }
  if (parsed.fault == NumberFault::kTooLarge) fail_at("number out of range: ", text);
  return parsed.value;
}

std::int64_t WordCursor::integer() {
  const std::string_view text = word();
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    fail_at("expected an integer, found ", text);
  }
  return value;
}

Point3 WordCursor::point() {
  const double x = number();
  const double y = number();
  const double z = number();
  return {x, y, z};
}

void WordCursor::fail(std::string_view reason) const {
  throw IoError(*path_, LineNumber{line_of(text_, latest_)}, reason);
}

}  // namespace tetsculpt
