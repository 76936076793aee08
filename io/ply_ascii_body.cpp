#include "io/ply_ascii_body.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "io/attribute_values.h"

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

Point3 vertex(TextScanner& in, const std::vector<PlyProperty>& properties,
              std::vector<Attribute>& attributes) {
  std::array<double, 3> xyz{};
  auto attribute = attributes.begin();
  for (const PlyProperty& property : properties) {
    if (property.list_length) {
      for (std::uint64_t left = in.count(); left > 0; --left) skip_value(in);
    } else if (property.role != PlyRole::kOther) {
      xyz[static_cast<std::size_t>(property.role)] = coordinate(in, property.type);
    } else {
      append_number(attribute->values, in);
      ++attribute;
    }
  }
  if (!in.at_line_end()) in.fail("the line has more values than the header says");
  return {xyz[0], xyz[1], xyz[2]};
}

}  // namespace

PointFile parse_ply_ascii_body(const PlyHeader& header, TextScanner& in) {
  for (const PlyElement& element : header.before_vertices) {
    if (element.properties.empty()) continue;  // no values, no line
    for (std::uint64_t i = 0; i < element.count; ++i) next_element(in, element, i);
  }
  const PlyElement& vertices = header.vertices;
  const auto room = static_cast<std::size_t>(std::min<std::uint64_t>(
      vertices.count, in.bytes_left() / (2 * vertices.properties.size()) + 1));
  PointFile file;
  file.points.reserve(room);
  for (const PlyProperty& property : vertices.properties) {
    if (property.role != PlyRole::kOther || property.list_length) continue;
    file.attributes.push_back({property.name, empty_values(property.type, room)});
  }
  while (file.points.size() < vertices.count) {
    next_element(in, vertices, file.points.size());
    file.points.push_back(vertex(in, vertices.properties, file.attributes));
  }
  return file;
}

}  // namespace tetsculpt
