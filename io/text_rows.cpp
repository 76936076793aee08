#include "io/text_rows.h"

#include <limits>
#include <type_traits>
#include <variant>

namespace tetsculpt {

void TextRows::add(std::string_view text) {
  make_room(text.size());
  if (text.size() > block_.size()) {
    out_.write(text);
    return;
  }
  text.copy(block_.data() + size_, text.size());
  size_ += text.size();
}

void TextRows::add_point(const Point3& point) {
  add_number(point.x);
  add(" ");
  add_number(point.y);
  add(" ");
  add_number(point.z);
}

void TextRows::add_indices(const std::array<std::uint32_t, 3>& triangle, std::uint64_t first) {
  add_number(first + triangle[0]);
  add(" ");
  add_number(first + triangle[1]);
  add(" ");
  add_number(first + triangle[2]);
}

void TextRows::add_triangles(std::span<const std::array<std::uint32_t, 3>> triangles,
                             std::string_view before, std::uint64_t first, std::string_view after) {
  for (const auto& triangle : triangles) {
    add(before);
    add_indices(triangle, first);
    add(after);
  }
}

void TextRows::add_value(const AttributeValues& values, std::size_t i) {
  std::visit([&](const auto& of_type) { add_number(of_type[i]); }, values);
}

void TextRows::add_share(const AttributeValues& values, std::size_t i) {
  std::visit(
      [&]<typename Value>(const std::vector<Value>& of_type) {
        if constexpr (std::is_integral_v<Value>) {
          constexpr auto kLargest = static_cast<double>(std::numeric_limits<Value>::max());
          add_number(static_cast<float>(of_type[i] / kLargest));
        } else {
          add_number(of_type[i]);
        }
      },
      values);
}

void TextRows::add_fraction(const AttributeValues& values, std::size_t i) {
  make_room(kLongestNumber);  // so that the number is in the block from here on
  const std::size_t begin = size_;
  add_share(values, i);
  const std::string_view number(block_.data() + begin, size_ - begin);
  if (number.find_first_of(".e") == std::string_view::npos) add(".0");
}

void TextRows::finish() {
  out_.write({block_.data(), size_});
  size_ = 0;
}

}  // namespace tetsculpt
