#include "io/off_reader.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace tetsculpt {

OffCounts parse_off_counts(TextScanner& in) {
  in.next_content_line();
  for (const std::string_view prefix : {"ST", "C", "N"}) in.accept(prefix);
  if (!in.accept("OFF")) in.fail("not an OFF file: it does not begin with OFF");
  if (in.at_line_end() && !in.next_content_line()) in.fail("the file ends before its counts");
  OffCounts counts{in.count(), {}};
  if (!in.at_line_end()) counts.faces = in.count();
  return counts;
}

std::vector<Point3> parse_off_points(std::string_view text, const std::filesystem::path& path) {
  constexpr TextDialect kDialect;
  constexpr std::size_t kShortestLine = 6;  // "0 0 0" and its end
  TextScanner in(text, path, kDialect);
  const std::uint64_t count = parse_off_counts(in).vertices;
  std::vector<Point3> points;
  points.reserve(std::min<std::uint64_t>(count, in.bytes_left() / kShortestLine + 1));
  while (points.size() < count) {
    if (!in.next_content_line()) {
      in.fail("the file ends after " + std::to_string(points.size()) + " of " +
              std::to_string(count) + " vertices");
    }
    points.push_back(in.point());
  }
  return points;
}

}  // namespace tetsculpt
