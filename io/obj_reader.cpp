#include "io/obj_reader.h"

#include "io/text_scanner.h"

namespace tetsculpt {

std::vector<Point3> parse_obj_points(std::string_view text, const std::filesystem::path& path) {
  constexpr TextDialect kDialect;
  TextScanner in(text, path, kDialect);
  std::vector<Point3> points;
  while (in.next_line()) {
    if (in.token() == "v") points.push_back(in.point());
  }
  return points;
}

}  // namespace tetsculpt
