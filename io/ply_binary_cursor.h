#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <type_traits>

#include "io/ply_header.h"

namespace tetsculpt {

/// Calls `function` with a std::type_identity of the C++ type.
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

/// Of a binary format.
std::endian byte_order(PlyFormat format);

bool has_list(const PlyElement& element);

/// The bytes of an element, of which each list counts as an empty one.
std::size_t least_size(const PlyElement& element);

/// A cursor over the values of a binary PLY file. What the file is too short for is thrown as
/// IoError with the byte where it would begin. Refers to the path, which must outlive it.
class PlyBinaryCursor {
 public:
  PlyBinaryCursor(std::string_view content, std::size_t begin, std::endian order,
                  const std::filesystem::path& path)
      : content_(content), at_(begin), order_(order), path_(path) {}

  std::endian order() const { return order_; }

  /// Makes sure that `count` times `size` bytes are left.
  void require(std::uint64_t count, std::size_t size, std::string_view what) const;

  /// The next `size` bytes. Precondition: they are there.
  const char* take(std::size_t size) {
    const char* const bytes = content_.data() + at_;
    at_ += size;
    return bytes;
  }

  double number(PlyType type);

  /// Takes the length of a list, whose items are then there. Stays where it is on a bad one.
  std::uint64_t list_length(const PlyProperty& list);

  void skip(const PlyProperty& property);
  void skip_elements(const PlyElement& element);

  [[noreturn]] void fail(std::string_view reason) const;

 private:
  std::string_view content_;
  std::size_t at_;
  std::endian order_;
  const std::filesystem::path& path_;
};

}  // namespace tetsculpt
