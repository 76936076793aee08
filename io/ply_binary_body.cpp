#include "io/ply_binary_body.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <type_traits>

#include "io/byte_order.h"
#include "io/io_error.h"

namespace tetsculpt {
namespace {

// Calls `function` with a std::type_identity of the C++ type.
template <typename Function>
auto with_type(PlyType type, Function function) {
  switch (type) {
    case PlyType::kInt8:
      return function(std::type_identity<std::int8_t>());
    case PlyType::kUint8:
      return function(std::type_identity<std::uint8_t>());
    case PlyType::kInt16:
      return function(std::type_identity<std::int16_t>());
    case PlyType::kUint16:
      return function(std::type_identity<std::uint16_t>());
    case PlyType::kInt32:
      return function(std::type_identity<std::int32_t>());
    case PlyType::kUint32:
      return function(std::type_identity<std::uint32_t>());
    case PlyType::kFloat32:
      return function(std::type_identity<float>());
    case PlyType::kFloat64:
      break;
  }
  return function(std::type_identity<double>());
}

class BinaryCursor {
 public:
  BinaryCursor(std::string_view content, std::size_t begin, std::endian order,
               const std::filesystem::path& path)
      : content_(content), at_(begin), order_(order), path_(path) {}

  std::endian order() const { return order_; }

  // Makes sure that `count` times `size` bytes are left.
  void require(std::uint64_t count, std::size_t size, std::string_view what) const {
    const std::size_t left = content_.size() - at_;
    if (count <= left / size) return;
    fail(std::string(what) + ": " + std::to_string(count) + " of at least " + std::to_string(size) +
         " bytes announced, " + std::to_string(left) + " bytes left");
  }

  // The next `size` bytes, which have to be there.
  const char* take(std::size_t size) {
    const char* const bytes = content_.data() + at_;
    at_ += size;
    return bytes;
  }

  double number(PlyType type) {
    require(1, byte_size(type), "value");
    return with_type(type, [this]<typename Number>(std::type_identity<Number>) {
      return static_cast<double>(load_number<Number>(take(sizeof(Number)), order_));
    });
  }

  // Leaves the cursor where it is on a bad length.
  void skip_list(const PlyProperty& list) {
    BinaryCursor behind_length = *this;
    const double length = behind_length.number(*list.list_length);
    if (length < 0) fail("negative length of a list");
    const auto items = static_cast<std::uint64_t>(length);
    behind_length.require(items, byte_size(list.type), "list items");
    at_ = behind_length.at_;
    take(static_cast<std::size_t>(items) * byte_size(list.type));
  }

 private:
  [[noreturn]] void fail(std::string_view reason) const {
    throw IoError(path_, ByteOffset{at_}, reason);
  }

  std::string_view content_;
  std::size_t at_;
  std::endian order_;
  const std::filesystem::path& path_;
};

bool has_list(const PlyElement& element) {
  return std::ranges::any_of(element.properties,
                             [](const PlyProperty& p) { return p.list_length.has_value(); });
}

// The bytes of an element, of which each list counts as an empty one.
std::size_t least_size(const PlyElement& element) {
  std::size_t size = 0;
  for (const PlyProperty& p : element.properties) size += byte_size(p.list_length.value_or(p.type));
  return size;
}

void skip_elements(const PlyElement& element, BinaryCursor& in) {
  const std::size_t size = least_size(element);
  if (size == 0) return;
  in.require(element.count, size, "elements " + element.name);
  if (!has_list(element)) {
    in.take(static_cast<std::size_t>(element.count) * size);
    return;
  }
  for (std::uint64_t i = 0; i < element.count; ++i) {
    for (const PlyProperty& property : element.properties) {
      if (property.list_length) {
        in.skip_list(property);
      } else {
        in.number(property.type);
      }
    }
  }
}

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

std::vector<Point3> vertices_of_fixed_size(const PlyElement& vertices, BinaryCursor& in) {
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

std::vector<Point3> vertices_with_lists(const PlyElement& vertices, BinaryCursor& in) {
  std::vector<Point3> points;
  points.reserve(static_cast<std::size_t>(vertices.count));
  while (points.size() < vertices.count) {
    std::array<double, 4> xyz_and_other{};
    for (const PlyProperty& property : vertices.properties) {
      if (property.list_length) {
        in.skip_list(property);
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
  const bool little = header.format == PlyFormat::kLittleEndian;
  BinaryCursor in(content, begin, little ? std::endian::little : std::endian::big, path);
  for (const PlyElement& element : header.before_vertices) skip_elements(element, in);
  in.require(header.vertices.count, least_size(header.vertices), "vertices");
  return has_list(header.vertices) ? vertices_with_lists(header.vertices, in)
                                   : vertices_of_fixed_size(header.vertices, in);
}

}  // namespace tetsculpt
