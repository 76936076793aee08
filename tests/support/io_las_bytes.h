#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/support/io_ply_bytes.h"

/// Building LAS files by hand.
namespace tetsculpt::testing {

struct Las {
  unsigned minor = 2;
  unsigned format = 0;
  std::uint16_t header_size = 227;
  std::uint32_t points_at = 227;
  std::uint16_t record_size = 20;
  std::uint32_t short_count = 0;
  std::uint64_t long_count = 0;  ///< written in version 1.4
  std::array<double, 3> scale = {1, 1, 1};
  std::array<double, 3> offset = {0, 0, 0};
  std::string records = {};
};

inline void put(std::string& file, std::size_t at, const std::string& bytes) {
  file.replace(at, bytes.size(), bytes);
}

inline std::string las_bytes(const Las& las) {
  constexpr std::endian kLittle = std::endian::little;
  std::string file(las.points_at, '\0');
  put(file, 0, "LASF");
  file[24] = 1;
  file[25] = static_cast<char>(las.minor);
  put(file, 94, bytes(las.header_size, kLittle));
  put(file, 96, bytes(las.points_at, kLittle));
  file[104] = static_cast<char>(las.format);
  put(file, 105, bytes(las.record_size, kLittle));
  put(file, 107, bytes(las.short_count, kLittle));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put(file, 131 + 8 * axis, bytes(las.scale[axis], kLittle));
    put(file, 155 + 8 * axis, bytes(las.offset[axis], kLittle));
  }
  if (las.minor == 4) put(file, 247, bytes(las.long_count, kLittle));
  return file + las.records;
}

/// A record of `size` bytes that are 0, 1, 2, ... but X, Y and Z, which are told.
inline std::string las_record(std::size_t size, std::array<std::int32_t, 3> xyz) {
  std::string record;
  for (const std::int32_t value : xyz) record += bytes(value, std::endian::little);
  for (std::size_t i = record.size(); i < size; ++i) record += static_cast<char>(i);
  return record;
}

/// One record, at 1, -2, 3, of a format in the oldest version that has it.
inline Las las_of_format(unsigned format) {
  Las las;
  las.format = format;
  las.minor = format >= 6 ? 4 : format >= 4 ? 3 : 2;
  constexpr std::array<std::uint16_t, 11> kSizes = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
  las.record_size = kSizes[format];
  if (las.minor == 4) las.header_size = 375;
  las.points_at = las.header_size;
  las.records = las_record(las.record_size, {1, -2, 3});
  if (las.minor == 4) {
    las.long_count = 1;
  } else {
    las.short_count = 1;
  }
  return las;
}

}  // namespace tetsculpt::testing
