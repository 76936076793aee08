#include "io/ply_binary_cursor.h"

#include <algorithm>
#include <string>

#include "io/byte_order.h"
#include "io/io_error.h"

namespace tetsculpt {

std::endian byte_order(PlyFormat format) {
  return format == PlyFormat::kLittleEndian ? std::endian::little : std::endian::big;
}

bool has_list(const PlyElement& element) {
  return std::ranges::any_of(element.properties,
                             [](const PlyProperty& p) { return p.list_length.has_value(); });
}

std::size_t least_size(const PlyElement& element) {
  std::size_t size = 0;
  for (const PlyProperty& p : element.properties) size += byte_size(p.list_length.value_or(p.type));
  return size;
}

void PlyBinaryCursor::require(std::uint64_t count, std::size_t size, std::string_view what) const {
  const std::size_t left = content_.size() - at_;
  if (count <= left / size) return;
  fail(std::string(what) + ": " + std::to_string(count) + " of at least " + std::to_string(size) +
       " bytes announced, " + std::to_string(left) + " bytes left");
}

double PlyBinaryCursor::number(PlyType type) {
  require(1, byte_size(type), "value");
  return with_type(type, [this]<typename Number>(std::type_identity<Number>) {
    return static_cast<double>(load_number<Number>(take(sizeof(Number)), order_));
  });
}

std::uint64_t PlyBinaryCursor::list_length(const PlyProperty& list) {
  PlyBinaryCursor behind_length = *this;
  const double length = behind_length.number(*list.list_length);
  if (length < 0) fail("negative length of a list");
  const auto items = static_cast<std::uint64_t>(length);
  behind_length.require(items, byte_size(list.type), "list items");
  at_ = behind_length.at_;
  return items;
}

void PlyBinaryCursor::skip(const PlyProperty& property) {
  if (property.list_length) {
    take(static_cast<std::size_t>(list_length(property)) * byte_size(property.type));
  } else {
    number(property.type);
  }
}

void PlyBinaryCursor::skip_elements(const PlyElement& element) {
  const std::size_t size = least_size(element);
  if (size == 0) return;
  require(element.count, size, "elements " + element.name);
  if (!has_list(element)) {
    take(static_cast<std::size_t>(element.count) * size);
    return;
  }
  for (std::uint64_t i = 0; i < element.count; ++i) {
    for (const PlyProperty& property : element.properties) skip(property);
  }
}

void PlyBinaryCursor::fail(std::string_view reason) const {
  throw IoError(path_, ByteOffset{at_}, reason);
}

}  // namespace tetsculpt
