#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace tetsculpt {

/// Types of numbers in files, integers first.
enum class NumberType {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64
};

/// Calls `function` with a std::type_identity of the C++ type.
template <typename Function>
auto with_type(NumberType type, Function function) {
  switch (type) {
    case NumberType::kInt8:
      return function(std::type_identity<std::int8_t>());
    case NumberType::kUint8:
      return function(std::type_identity<std::uint8_t>());
    case NumberType::kInt16:
      return function(std::type_identity<std::int16_t>());
    case NumberType::kUint16:
      return function(std::type_identity<std::uint16_t>());
    case NumberType::kInt32:
      return function(std::type_identity<std::int32_t>());
    case NumberType::kUint32:
      return function(std::type_identity<std::uint32_t>());
    case NumberType::kInt64:
      return function(std::type_identity<std::int64_t>());
    case NumberType::kUint64:
      return function(std::type_identity<std::uint64_t>());
    case NumberType::kFloat32:
      return function(std::type_identity<float>());
    case NumberType::kFloat64:
      break;
  }
  return function(std::type_identity<double>());
}

inline std::size_t byte_size(NumberType type) {
  return with_type(type,
                   []<typename Number>(std::type_identity<Number>) { return sizeof(Number); });
}

}  // namespace tetsculpt
