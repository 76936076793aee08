#include "io/ply_ascii_body.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

namespace tetsculpt {
namespace {

void next_element(TextScanner& in, const PlyElement& element, std::uint64_t index) {
  if (in.next_content_line()) return;
  in.fail("the file ends after " + std::to_string(index) + " of " + std::to_string(element.count) +
          " elements " + element.name);
}

void skip_value(TextScanner& in) {
  if (in.token().empty()) in.fail("the line has fewer values than the header says");
}

double coordinate(TextScanner& in, PlyType type) {
  if (type == PlyType::kFloat32) return static_cast<double>(in.number<float>());
  return in.number<double>();
}

Point3 vertex(TextScanner& in, const std::vector<PlyProperty>& properties) {
  std::array<double, 3> xyz{};
  for (const PlyProperty& property : properties) {
    if (property.role != PlyRole::kOther) {
      xyz[static_cast<std::size_t>(property.role)] = coordinate(in, property.type);
      continue;
    }
    for (std::uint64_t left = property.list_length ? in.count() : 1; left > 0; --left) {
      skip_value(in);
    }
  }
  if (!in.at_line_end()) in.fail("the line has more values than the header says");
  return {xyz[0], xyz[1], xyz[2]};
}

}  // namespace

std::vector<Point3> parse_ply_ascii_body(const PlyHeader& header, TextScanner& in) {
  for (const PlyElement& element : header.before_vertices) {
    if (element.properties.empty()) continue;  // no values, no line
    for (std::uint64_t i = 0; i < element.count; ++i) next_element(in, element, i);
  }
  constexpr std::size_t kShortestLine = 6;  // "0 0 0" and its end
  std::vector<Point3> points;
  points.reserve(
      std::min<std::uint64_t>(header.vertices.count, in.bytes_left() / kShortestLine + 1));
  while (points.size() < header.vertices.count) {
    next_element(in, header.vertices, points.size());
    points.push_back(vertex(in, header.vertices.properties));
  }
  return points;
}

}  // namespace tetsculpt
