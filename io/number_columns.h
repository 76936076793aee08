#pragma once

#include <bit>
#include <cstddef>
#include <variant>

#include "io/attribute.h"
#include "io/byte_order.h"

/// Columns of numbers in binary files.
namespace tetsculpt {

/// `count` rows, beginning with number `first`.
struct RowRange {
  std::size_t first;
  std::size_t count;
};

/// Puts number(i) for each row i of `rows` at `to`, `to + stride`, ...
template <typename Number>
void store_column(char* to, std::size_t stride, RowRange rows, std::endian order,
                  const Number& number) {
  for (std::size_t i = rows.first; i < rows.first + rows.count; ++i, to += stride) {
    store_number(to, number(i), order);
  }
}

inline void store_values(char* to, std::size_t stride, RowRange rows, std::endian order,
                         const AttributeValues& values) {
  std::visit(
      [&](const auto& of_type) {
        store_column(to, stride, rows, order, [&](std::size_t i) { return of_type[i]; });
      },
      values);
}

/// Bytes of one value.
inline std::size_t value_size(const AttributeValues& values) {
  return std::visit([](const auto& of_type) { return sizeof(of_type[0]); }, values);
}

/// Calls visit(RowRange) on all rows of 0..count, in order, in pieces of some thousands.
template <typename Visit>
void in_pieces(std::size_t count, const Visit& visit) {
  constexpr std::size_t kPiece = 4096;
  for (std::size_t first = 0; first < count; first += kPiece) {
    visit(RowRange{first, count - first < kPiece ? count - first : kPiece});
  }
}

}  // namespace tetsculpt
