#include "io/ply_binary_body.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "io/byte_order.h"
#include "io/ply_binary_cursor.h"

namespace tetsculpt {
namespace {

// Where a coordinate stands in a vertex without lists.
struct Column {
  PlyType type = PlyType::kFloat32;
  std::size_t offset = 0;
};

std::array<Column, 3> columns_of(const PlyElement& vertices) {
  std::array<Column, 3> columns;
  std::size_t offset = 0;
  for (const PlyProperty& property : vertices.properties) {
    if (property.role != PlyRole::kOther) {
      columns[static_cast<std::size_t>(property.role)] = {property.type, offset};
    }
    offset += byte_size(property.type);
  }
  return columns;
}

template <typename Number>
double load_as_double(const char* from, std::endian order) {
  return static_cast<double>(load_number<Number>(from, order));
}

// load(bytes, column) gives one coordinate.
template <typename Load>
std::vector<Point3> load_points(std::string_view bytes, std::size_t count,
                                const std::array<Column, 3>& columns, Load load) {
  std::vector<Point3> points(count);
  const std::size_t size = count == 0 ? 0 : bytes.size() / count;
  const char* vertex = bytes.data();
  for (Point3& point : points) {
    point = {load(vertex, columns[0]), load(vertex, columns[1]), load(vertex, columns[2])};
    vertex += size;
  }
  return points;
}

std::vector<Point3> vertices_of_fixed_size(const PlyElement& vertices, PlyBinaryCursor& in) {
  const auto count = static_cast<std::size_t>(vertices.count);
  const std::size_t size = count * least_size(vertices);
  const std::string_view bytes(in.take(size), size);
  const std::array<Column, 3> columns = columns_of(vertices);
  const PlyType type = columns[0].type;
  if (columns[1].type == type && columns[2].type == type) {  // nearly always: a loop per type
    return with_type(type, [&]<typename Number>(std::type_identity<Number>) {
      return load_points(bytes, count, columns,
                         [order = in.order()](const char* vertex, const Column& column) {
                           return load_as_double<Number>(vertex + column.offset, order);
                         });
    });
  }
  return load_points(bytes, count, columns, [&](const char* vertex, const Column& column) {
    return with_type(column.type, [&]<typename Number>(std::type_identity<Number>) {
      return load_as_double<Number>(vertex + column.offset, in.order());
    });
  });
}

std::vector<Point3> vertices_with_lists(const PlyElement& vertices, PlyBinaryCursor& in) {
  std::vector<Point3> points;
  points.reserve(static_cast<std::size_t>(vertices.count));
  while (points.size() < vertices.count) {
    std::array<double, 4> xyz_and_other{};
    for (const PlyProperty& property : vertices.properties) {
      if (property.list_length) {
        in.skip(property);
      } else {
        xyz_and_other[static_cast<std::size_t>(property.role)] = in.number(property.type);
      }
    }
    points.push_back({xyz_and_other[0], xyz_and_other[1], xyz_and_other[2]});
  }
  return points;
}

}  // namespace

std::vector<Point3> parse_ply_binary_body(const PlyHeader& header, std::string_view content,
                                          std::size_t begin, const std::filesystem::path& path) {
  PlyBinaryCursor in(content, begin, byte_order(header.format), path);
  for (const PlyElement& element : header.before_vertices) in.skip_elements(element);
  in.require(header.vertices.count, least_size(header.vertices), "vertices");
  return has_list(header.vertices) ? vertices_with_lists(header.vertices, in)
                                   : vertices_of_fixed_size(header.vertices, in);
}

}  // namespace tetsculpt
