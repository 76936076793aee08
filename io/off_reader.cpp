#include "io/off_reader.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "io/text_scanner.h"

namespace tetsculpt {
namespace {

// Leaves `in` behind the counts.
std::uint64_t vertex_count(TextScanner& in) {
  in.next_content_line();
  for (const std::string_view prefix : {"ST", "C", "N"}) in.accept(prefix);
  if (!in.accept("OFF")) in.fail("not an OFF file: it does not begin with OFF");
  if (in.at_line_end() && !in.next_content_line()) in.fail("the file ends before its counts");
  const std::uint64_t vertices = in.count();
  if (!in.at_line_end()) in.count();  // the faces
  return vertices;
}

}  // namespace

std::vector<Point3> parse_off_points(std::string_view text, const std::filesystem::path& path) {
  constexpr TextDialect kDialect;
  constexpr std::size_t kShortestLine = 6;  // "0 0 0" and its end
  TextScanner in(text, path, kDialect);
  const std::uint64_t count = vertex_count(in);
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
