// Legacy files as "VTK File Formats" (Kitware) describes them.
#include "io/vtk_cursor.h"

#include <bit>
#include <string>
#include <type_traits>

#include "io/byte_order.h"
#include "io/io_error.h"
#include "io/quoted.h"
#include "io/vtk_types.h"

namespace tetsculpt {
void VtkCursor::expect(std::string_view expected) {
  if (word() != expected) fail("expected " + std::string(expected));
}

std::uint64_t VtkCursor::count() {
  const std::int64_t value = words_.integer();
  if (value < 0) words_.fail("a negative count");
  return static_cast<std::uint64_t>(value);
}

NumberType VtkCursor::type() {
  const std::string_view name = word();
  if (const auto type = vtk_type_named(name)) return *type;
  words_.fail("unknown type " + quoted(name));
}

void VtkCursor::begin_values(std::uint64_t count, NumberType type) {
  if (binary_ && count > 0) words_.rest_of_line();
  const std::size_t size = binary_ ? byte_size(type) : 2;  // a digit and a separator
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

double VtkCursor::number(NumberType type) {
  if (!binary_) return words_.number();
  return with_type(type, [this]<typename Number>(std::type_identity<Number>) {
    return static_cast<double>(load<Number>());
  });
}

std::int64_t VtkCursor::integer(NumberType type) {
  if (!binary_) return words_.integer();
  return with_type(type, [this]<typename Number>(std::type_identity<Number>) {
    return static_cast<std::int64_t>(load<Number>());
  });
}

void VtkCursor::skip_values(std::uint64_t count, NumberType type) {
  begin_values(count, type);
  if (binary_) {
    words_.go_to(words_.offset() + static_cast<std::size_t>(count) * byte_size(type));
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
