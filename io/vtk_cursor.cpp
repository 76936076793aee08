// Legacy files as "VTK File Formats" (Kitware) describes them, with the type names of version 5.1.
#include "io/vtk_cursor.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <type_traits>

#include "io/byte_order.h"
#include "io/io_error.h"
#include "io/quoted.h"

namespace tetsculpt {
namespace {

struct TypeName {
  std::string_view name;
  VtkType type;
};

constexpr std::array<TypeName, 13> kTypeNames = {{
    {"char", VtkType::kInt8},
    {"unsigned_char", VtkType::kUint8},
    {"short", VtkType::kInt16},
    {"unsigned_short", VtkType::kUint16},
    {"int", VtkType::kInt32},
    {"vtkIdType", VtkType::kInt32},
    {"unsigned_int", VtkType::kUint32},
    {"long", VtkType::kInt64},
    {"vtktypeint64", VtkType::kInt64},
    {"unsigned_long", VtkType::kUint64},
    {"vtktypeuint64", VtkType::kUint64},
    {"float", VtkType::kFloat32},
    {"double", VtkType::kFloat64},
}};

// Calls `function` with a std::type_identity of the C++ type.
template <typename Function>
auto with_vtk_type(VtkType type, Function function) {
  switch (type) {
    case VtkType::kInt8:
      return function(std::type_identity<std::int8_t>());
    case VtkType::kUint8:
      return function(std::type_identity<std::uint8_t>());
    case VtkType::kInt16:
      return function(std::type_identity<std::int16_t>());
    case VtkType::kUint16:
      return function(std::type_identity<std::uint16_t>());
    case VtkType::kInt32:
      return function(std::type_identity<std::int32_t>());
    case VtkType::kUint32:
      return function(std::type_identity<std::uint32_t>());
    case VtkType::kInt64:
      return function(std::type_identity<std::int64_t>());
    case VtkType::kUint64:
      return function(std::type_identity<std::uint64_t>());
    case VtkType::kFloat32:
      return function(std::type_identity<float>());
    case VtkType::kFloat64:
      break;
  }
  return function(std::type_identity<double>());
}

std::size_t size_of(VtkType type) {
  return with_vtk_type(type,
                       []<typename Number>(std::type_identity<Number>) { return sizeof(Number); });
}

}  // namespace

void VtkCursor::expect(std::string_view expected) {
  if (word() != expected) fail("expected " + std::string(expected));
}

std::uint64_t VtkCursor::count() {
  const std::int64_t value = words_.integer();
  if (value < 0) words_.fail("a negative count");
  return static_cast<std::uint64_t>(value);
}

VtkType VtkCursor::type() {
  const std::string_view name = word();
  const auto* found = std::ranges::find(kTypeNames, name, &TypeName::name);
  if (found == kTypeNames.end()) words_.fail("unknown type " + quoted(name));
  return found->type;
}

void VtkCursor::begin_values(std::uint64_t count, VtkType type) {
  if (binary_ && count > 0) words_.rest_of_line();
  const std::size_t size = binary_ ? size_of(type) : 2;  // a digit and a separator
  latest_ = words_.offset();
  if (count <= words_.bytes_left() / size + (binary_ ? 0 : 1)) return;
  fail(std::to_string(count) + " values announced, " + std::to_string(words_.bytes_left()) +
       " bytes left");
}

template <typename Number>
Number VtkCursor::load() {
  latest_ = words_.offset();
  if (words_.bytes_left() < sizeof(Number)) fail("the file ends within its values");
  words_.go_to(latest_ + sizeof(Number));
  return load_number<Number>(content_.data() + latest_, std::endian::big);
}

double VtkCursor::number(VtkType type) {
  if (!binary_) return words_.number();
  return with_vtk_type(type, [this]<typename Number>(std::type_identity<Number>) {
    return static_cast<double>(load<Number>());
  });
}

std::int64_t VtkCursor::integer(VtkType type) {
  if (!binary_) return words_.integer();
  return with_vtk_type(type, [this]<typename Number>(std::type_identity<Number>) {
    return static_cast<std::int64_t>(load<Number>());
  });
}

void VtkCursor::skip_values(std::uint64_t count, VtkType type) {
  begin_values(count, type);
  if (binary_) {
    words_.go_to(words_.offset() + static_cast<std::size_t>(count) * size_of(type));
    return;
  }
  for (; count > 0; --count) {
    if (word().empty()) fail("the file ends within its values");
  }
}

void VtkCursor::fail(std::string_view reason) const {
  if (!binary_) words_.fail(reason);
  throw IoError(path_, ByteOffset{latest_}, reason);
}

}  // namespace tetsculpt
