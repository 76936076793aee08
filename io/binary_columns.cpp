#include "io/binary_columns.h"

#include <type_traits>
#include <utility>

#include "io/attribute_values.h"
#include "io/byte_order.h"

namespace tetsculpt {
namespace {

// load(column, i) gives number i of a column as a double.
template <typename Load>
std::vector<Point3> load_points(const std::array<BinaryColumn, 3>& xyz, std::size_t count,
                                Load load) {
  std::vector<Point3> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back({load(xyz[0], i), load(xyz[1], i), load(xyz[2], i)});
  }
  return points;
}

template <typename Number>
double load_as_double(const BinaryColumn& column, std::size_t i, std::endian order) {
  return static_cast<double>(load_number<Number>(column.first + i * column.stride, order));
}

}  // namespace

std::vector<Point3> points_of(const std::array<BinaryColumn, 3>& xyz, std::size_t count,
                              std::endian order) {
  const NumberType type = xyz[0].type;
  if (xyz[1].type == type && xyz[2].type == type) {  // nearly always: a loop per type
    return with_type(type, [&]<typename Number>(std::type_identity<Number>) {
      return load_points(xyz, count, [order](const BinaryColumn& column, std::size_t i) {
        return load_as_double<Number>(column, i, order);
      });
    });
  }
  return load_points(xyz, count, [order](const BinaryColumn& column, std::size_t i) {
    return with_type(column.type, [&]<typename Number>(std::type_identity<Number>) {
      return load_as_double<Number>(column, i, order);
    });
  });
}

AttributeValues values_of(const BinaryColumn& column, std::size_t count, std::endian order) {
  return with_type(column.type,
                   [&]<typename Number>(std::type_identity<Number>) -> AttributeValues {
                     using Value = AttributeValue<Number>;
                     std::vector<Value> values;
                     values.reserve(count);
                     for (std::size_t i = 0; i < count; ++i) {
                       const char* const from = column.first + i * column.stride;
                       values.push_back(static_cast<Value>(load_number<Number>(from, order)));
                     }
                     return values;
                   });
}

}  // namespace tetsculpt
