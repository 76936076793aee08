#include "io/text_points.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

#include "io/io_error.h"
#include "io/text_scanner.h"

namespace tetsculpt {
namespace {

constexpr TextDialect kDialect = {.separators = " \t,;", .comments = {"#", "//"}};

struct AnnouncedCount {
  std::uint64_t value;
  std::uint64_t line;
};

bool is_lone_count(TextScanner line) {
  const std::string_view token = line.token();
  return line.at_line_end() &&
         std::ranges::all_of(token, [](char c) { return c >= '0' && c <= '9'; });
}

// The lines before the first point.
class Header {
 public:
  // True if the line, looked at and left as it is, belongs to the header.
  bool takes(const TextScanner& line) {
    TextScanner look = line;
    if (!titled_ && !look.at_number()) {
      titled_ = true;
      return true;
    }
    if (!count_ && is_lone_count(line)) {
      count_ = AnnouncedCount{look.count(), line.line_number()};
      return true;
    }
    return false;
  }

  const std::optional<AnnouncedCount>& count() const { return count_; }

 private:
  bool titled_ = false;
  std::optional<AnnouncedCount> count_;
};

}  // namespace

std::vector<Point3> parse_text_points(std::string_view text, const std::filesystem::path& path) {
  TextScanner in(text, path, kDialect);
  std::vector<Point3> points;
  Header header;
  while (in.next_content_line()) {
    if (points.empty() && header.takes(in)) continue;
    points.push_back(in.point());
  }
  if (const auto& count = header.count(); count && count->value != points.size()) {
    throw IoError(path, LineNumber{count->line},
                  "announced points: " + std::to_string(count->value) +
                      ", points in the file: " + std::to_string(points.size()));
  }
  return points;
}

}  // namespace tetsculpt
