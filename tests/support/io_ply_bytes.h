#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <string_view>

/// Building PLY files by hand.
namespace tetsculpt::testing {

/// The bytes of `value` in `order`.
template <typename Number>
std::string bytes(Number value, std::endian order) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
  if (order != std::endian::native) std::ranges::reverse(raw);
  return {raw.data(), raw.size()};
}

inline std::string_view format_name(std::endian order) {
  return order == std::endian::little ? "binary_little_endian" : "binary_big_endian";
}

/// A header whose lines between `format` and `end_header` are `elements`.
inline std::string ply_header(std::string_view format, std::string_view elements) {
  return std::string("ply\nformat ")
      .append(format)
      .append(" 1.0\n")
      .append(elements)
      .append("end_header\n");
}

inline constexpr std::string_view kXyzFloat =
    "property float x\nproperty float y\nproperty float z\n";

}  // namespace tetsculpt::testing
