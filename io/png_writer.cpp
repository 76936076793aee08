#include "io/png_writer.h"

#include <array>
#include <cassert>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "io/atomic_file.h"
#include "io/deflate.h"

namespace tetsculpt {
namespace {

using Row = std::span<const std::uint8_t>;

constexpr std::size_t kChannels = 3;
enum Filter : std::uint8_t { kNone, kSub, kUp, kAverage, kPaeth };

constexpr std::array<std::uint32_t, 256> crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < table.size(); ++byte) {
    std::uint32_t rest = byte;
    for (int i = 0; i < 8; ++i) rest = (rest & 1) != 0 ? 0xedb88320U ^ rest >> 1 : rest >> 1;
    table[byte] = rest;
  }
  return table;
}

std::uint32_t crc32(std::string_view bytes) {
  static constexpr std::array<std::uint32_t, 256> kTable = crc_table();
  std::uint32_t crc = 0xffffffffU;
  for (const char byte : bytes)
    crc = kTable[(crc ^ static_cast<std::uint8_t>(byte)) & 0xff] ^ crc >> 8;
  return ~crc;
}

void append_big_endian(std::string& to, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) to.push_back(static_cast<char>(value >> shift & 0xff));
}

void append_chunk(std::string& to, std::string_view name, std::string_view content) {
  append_big_endian(to, static_cast<std::uint32_t>(content.size()));
  const std::size_t start = to.size();
  to.append(name).append(content);
  append_big_endian(to, crc32(std::string_view(to).substr(start)));
}

// The one of the three that is nearest to left + up - corner.
int paeth(int left, int up, int corner) {
  const int to_left = std::abs(up - corner);
  const int to_up = std::abs(left - corner);
  const int to_corner = std::abs(left + up - 2 * corner);
  if (to_left <= to_up && to_left <= to_corner) return left;
  return to_up <= to_corner ? up : corner;
}

int predicted(Filter filter, int left, int up, int corner) {
  switch (filter) {
    case kSub:
      return left;
    case kUp:
      return up;
    case kAverage:
      return (left + up) / 2;
    case kPaeth:
      return paeth(left, up, corner);
    default:
      return 0;
  }
}

// The filter's number and what it leaves of the row. `above` is as long, zero above the first row.
std::string filtered(Row row, Row above, Filter filter) {
  std::string result(1, static_cast<char>(filter));
  for (std::size_t i = 0; i < row.size(); ++i) {
    const int left = i < kChannels ? 0 : row[i - kChannels];
    const int corner = i < kChannels ? 0 : above[i - kChannels];
    result.push_back(static_cast<char>(row[i] - predicted(filter, left, above[i], corner)));
  }
  return result;
}

// Small differences, of either sign, make for short codes.
std::size_t size_of_differences(std::string_view filtered_row) {
  std::size_t sum = 0;
  for (const char byte : filtered_row.substr(1)) {
    sum += static_cast<std::size_t>(std::abs(static_cast<std::int8_t>(byte)));
  }
  return sum;
}

std::string filtered_rows(const Image& image) {
  std::string result;
  const std::size_t size = kChannels * image.width;
  const std::vector<std::uint8_t> nothing(size);
  Row above = nothing;
  for (std::size_t y = 0; y < image.height; ++y) {
    const Row row = Row(image.rgb).subspan(y * size, size);
    std::string best;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (const Filter filter : {kNone, kSub, kUp, kAverage, kPaeth}) {
      std::string candidate = filtered(row, above, filter);
      const std::size_t differences = size_of_differences(candidate);
      if (differences >= least) continue;
      least = differences;
      best = std::move(candidate);
    }
    result += best;
    above = row;
  }
  return result;
}

}  // namespace

std::string png(const Image& image) {
  [[maybe_unused]] constexpr std::size_t kLargest = std::numeric_limits<std::int32_t>::max();
  assert(image.width >= 1 && image.width <= kLargest);
  assert(image.height >= 1 && image.height <= kLargest);
  assert(image.rgb.size() == kChannels * image.width * image.height);
  std::string header;
  append_big_endian(header, static_cast<std::uint32_t>(image.width));
  append_big_endian(header, static_cast<std::uint32_t>(image.height));
  header.append(
      {8, 2, 0, 0, 0});  // bits, red green blue, the one compression, the one set of filters

  std::string file = "\x89PNG\r\n\x1a\n";
  append_chunk(file, "IHDR", header);
  const std::string stream = zlib_stream(filtered_rows(image));
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  for (std::size_t at = 0; at < stream.size(); at += kPiece) {
    append_chunk(file, "IDAT", std::string_view(stream).substr(at, kPiece));
  }
  append_chunk(file, "IEND", {});
  return file;
}

void write_png(const Image& image, const std::filesystem::path& path) {
  AtomicFile out(path);
  out.write(png(image));
  out.commit();
}

}  // namespace tetsculpt
