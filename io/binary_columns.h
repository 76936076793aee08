#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <vector>

#include "io/attribute.h"
#include "io/number_type.h"
#include "kernel/point.h"

/// Numbers that stand in memory at even distances, as in the records of a binary file.
namespace tetsculpt {

struct BinaryColumn {
  NumberType type = NumberType::kFloat32;
  const char* first = nullptr;  ///< the bytes of the first number, aligned or not
  std::size_t stride = 0;       ///< bytes from one number to the next
};

/// `count` points whose x, y and z are the columns. Each becomes the nearest double.
/// Precondition of both: the bytes of all numbers are there. Cost: memory bandwidth, if x, y and z
/// are of one type.
std::vector<Point3> points_of(const std::array<BinaryColumn, 3>& xyz, std::size_t count,
                              std::endian order);

/// `count` values; 64-bit integers become doubles, the nearest ones.
AttributeValues values_of(const BinaryColumn& column, std::size_t count, std::endian order);

}  // namespace tetsculpt
