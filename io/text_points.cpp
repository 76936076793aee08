#include "io/text_points.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "io/io_error.h"
#include "io/point_rows.h"
#include "io/text_scanner.h"

namespace tetsculpt {
namespace {

constexpr TextDialect kDialect = {.separators = " \t", .delimiters = ",;", .comments = {"#", "//"}};

struct AnnouncedCount {
  std::uint64_t value;
  std::uint64_t line;
};

bool is_lone_count(TextScanner line) {
  const std::string_view token = line.token();
  return line.at_line_end() &&
         std::ranges::all_of(token, [](char c) { return c >= '0' && c <= '9'; });
}

// Spreadsheets end with lines of nothing but commas.
bool is_empty(TextScanner line) {
  while (!line.next_cell().empty()) {
  }
  return line.at_line_end();
}

// Titles may begin with an empty cell, over a column of row numbers.
bool begins_with_number(TextScanner line) {
  while (!line.next_cell().empty()) {
  }
  return line.at_number();
}

// The lines before the first point.
class Header {
 public:
  explicit Header(TextColumns usual) : names_(usual) {}

  // True if the line, looked at and left as it is, belongs to the header.
  bool takes(const TextScanner& line) {
    TextScanner look = line;
    if (look.at_line_end()) {
      names_.take_comment(line.rest_of_line());
      return true;
    }
    if (is_empty(line)) return true;
    if (!titled_ && !begins_with_number(line)) {
      titled_ = true;
      names_.take_titles(line.rest_of_line());
      return true;
    }
    if (!count_ && is_lone_count(line)) {
      count_ = AnnouncedCount{look.count(), line.line_number()};
      return true;
    }
    return false;
  }

  // For the first row.
  PointRows rows(const TextScanner& line) const {
    PointRows rows(names_.of_row(line));
    const std::size_t row_size = line.rest_of_line().size() + 1;
    rows.reserve(line.bytes_left() / row_size + 1);
    return rows;
  }

  const std::optional<AnnouncedCount>& count() const { return count_; }

 private:
  TextColumnNames names_;
  bool titled_ = false;
  std::optional<AnnouncedCount> count_;
};

}  // namespace

PointFile parse_text_points(std::string_view text, const std::filesystem::path& path,
                            TextColumns usual) {
  TextScanner in(text, path, kDialect);
  Header header(usual);
  std::optional<PointRows> rows;
  while (in.next_line()) {
    if (!rows) {
      if (header.takes(in)) continue;
      rows = header.rows(in);
    } else if (in.at_line_end() || (in.at_delimiter() && is_empty(in))) {
      continue;
    }
    rows->take(in);
  }
  const std::size_t points = rows ? rows->size() : 0;
  if (const auto& count = header.count(); count && count->value != points) {
    throw IoError(path, LineNumber{count->line},
                  "announced points: " + std::to_string(count->value) +
                      ", points in the file: " + std::to_string(points));
  }
  return rows ? std::move(*rows).finish() : PointFile();
}

}  // namespace tetsculpt
