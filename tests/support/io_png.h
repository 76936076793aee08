#pragma once

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>

#include "io/byte_order.h"
#include "io/image.h"
#include "tests/support/io_inflate.h"

/// The reader of PNG files that the tests of the writer rest on.
namespace tetsculpt::testing {

/// The sum of a PNG chunk, bit by bit as its standard defines it.
inline std::uint32_t png_crc(std::string_view bytes) {
  std::uint32_t rest = 0xffffffffU;
  for (const char byte : bytes) {
    rest ^= static_cast<std::uint8_t>(byte);
    for (int i = 0; i < 8; ++i) rest = rest >> 1 ^ ((rest & 1) != 0 ? 0xedb88320U : 0U);
  }
  return ~rest;
}

/// The chunk with which `rest` begins, taken off it.
inline std::string_view take_png_chunk(std::string_view& rest, std::string& name) {
  const auto word = [&](std::size_t at) {
    return load_number<std::uint32_t>(rest.substr(at, 4).data(), std::endian::big);
  };
  if (rest.size() < 12 || rest.size() < 12 + std::size_t{word(0)}) {
    throw std::runtime_error("png: chunk is cut off");
  }
  const std::size_t size = word(0);
  name = rest.substr(4, 4);
  const std::string_view content = rest.substr(8, size);
  if (png_crc(rest.substr(4, 4 + size)) != word(8 + size)) throw std::runtime_error("png: sum");
  rest.remove_prefix(12 + size);
  return content;
}

/// What a filter foretells of a byte from its neighbours.
inline int png_prediction(int filter, int left, int up, int corner) {
  if (filter == 1) return left;
  if (filter == 2) return up;
  if (filter == 3) return (left + up) / 2;
  if (filter != 4) return 0;
  const int p = left + up - corner;
  const int a = std::abs(p - left);
  const int b = std::abs(p - up);
  const int c = std::abs(p - corner);
  return a <= b && a <= c ? left : b <= c ? up : corner;
}

/// The picture in a file of the kind that the project writes: 8 bits, no alpha, not interlaced.
/// Throws std::runtime_error on anything else.
inline Image image_of_png(std::string_view file) {
  const std::string_view signature("\x89PNG\r\n\x1a\n", 8);
  if (!file.starts_with(signature)) throw std::runtime_error("png: signature");
  file.remove_prefix(signature.size());
  std::string name;
  const std::string header(take_png_chunk(file, name));
  if (name != "IHDR" || header.substr(8) != std::string("\x08\x02\0\0\0", 5)) {
    throw std::runtime_error("png: header");
  }
  Image image;
  image.width = load_number<std::uint32_t>(header.data(), std::endian::big);
  image.height = load_number<std::uint32_t>(header.data() + 4, std::endian::big);
  std::string stream;
  for (stream = take_png_chunk(file, name); name == "IDAT";) {
    const std::string_view content = take_png_chunk(file, name);
    if (name == "IDAT") stream += content;
  }
  if (name != "IEND" || !file.empty()) throw std::runtime_error("png: end");
  const std::string rows = inflated(stream).bytes;
  const std::size_t size = 3 * image.width;
  if (rows.size() != (size + 1) * image.height) throw std::runtime_error("png: size");
  for (std::size_t y = 0; y < image.height; ++y) {
    const int filter = rows[y * (size + 1)];
    if (filter < 0 || filter > 4) throw std::runtime_error("png: filter");
    for (std::size_t x = 0; x < size; ++x) {
      const std::size_t at = y * size + x;
      const int left = x < 3 ? 0 : image.rgb[at - 3];
      const int up = y == 0 ? 0 : image.rgb[at - size];
      const int corner = x < 3 || y == 0 ? 0 : image.rgb[at - size - 3];
      const int rest = rows[y * (size + 1) + 1 + x];
      image.rgb.push_back(
          static_cast<std::uint8_t>(rest + png_prediction(filter, left, up, corner)));
    }
  }
  return image;
}

}  // namespace tetsculpt::testing
