#include "io/ply_binary_body.h"

#include <array>
#include <cstdint>
#include <utility>

#include "io/attribute_values.h"
#include "io/binary_columns.h"
#include "io/ply_binary_cursor.h"

namespace tetsculpt {
namespace {

PointFile vertices_of_fixed_size(const PlyElement& vertices, PlyBinaryCursor& in) {
  const auto count = static_cast<std::size_t>(vertices.count);
  const std::size_t stride = least_size(vertices);
  const char* first = in.take(count * stride);
  PointFile file;
  std::array<BinaryColumn, 3> xyz;
  for (const PlyProperty& property : vertices.properties) {
    const BinaryColumn column{property.type, first, stride};
    if (property.role == PlyRole::kOther) {
      file.attributes.push_back({property.name, values_of(column, count, in.order())});
    } else {
      xyz[static_cast<std::size_t>(property.role)] = column;
    }
    first += byte_size(property.type);
  }
  file.points = points_of(xyz, count, in.order());
  return file;
}

PointFile vertices_with_lists(const PlyElement& vertices, PlyBinaryCursor& in) {
  const auto count = static_cast<std::size_t>(vertices.count);
  PointFile file;
  file.points.reserve(count);
  for (const PlyProperty& property : vertices.properties) {
    if (property.role != PlyRole::kOther || property.list_length) continue;
    file.attributes.push_back({property.name, empty_values(property.type, count)});
  }
  while (file.points.size() < count) {
    std::array<double, 3> xyz{};
    auto attribute = file.attributes.begin();
    for (const PlyProperty& property : vertices.properties) {
      if (property.list_length) {
        in.skip(property);
      } else if (property.role != PlyRole::kOther) {
        xyz[static_cast<std::size_t>(property.role)] = in.number(property.type);
      } else {
        const std::size_t size = byte_size(property.type);
        in.require(1, size, "value");
        append_number(attribute->values, property.type, in.take(size), in.order());
        ++attribute;
      }
    }
    file.points.push_back({xyz[0], xyz[1], xyz[2]});
  }
  return file;
}

}  // namespace

PointFile parse_ply_binary_body(const PlyHeader& header, std::string_view content,
                                std::size_t begin, const std::filesystem::path& path) {
  PlyBinaryCursor in(content, begin, byte_order(header.format), path);
  for (const PlyElement& element : header.before_vertices) in.skip_elements(element);
  in.require(header.vertices.count, least_size(header.vertices), "vertices");
  return has_list(header.vertices) ? vertices_with_lists(header.vertices, in)
                                   : vertices_of_fixed_size(header.vertices, in);
}

}  // namespace tetsculpt
