#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetsculpt {

/// In sRGB, as screens and files have it.
struct Colour {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;

  friend bool operator==(const Colour&, const Colour&) = default;
};

/// Rows from the top, each from the left, three bytes (r, g, b) per pixel: 3 * width * height.
struct Image {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> rgb;
};

}  // namespace tetsculpt
