// LAS: the fields of every point format become attributes.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/io_files.h"
#include "tests/support/io_las_bytes.h"
#include "tests/support/io_point_attributes.h"

namespace tetsculpt {
namespace {

using testing::attribute_names;
using testing::has_values;
using testing::Las;
using testing::las_bytes;
using testing::las_of_format;
using testing::read_content;

PointFile read(const Las& las) { return read_content("a.las", las_bytes(las)); }

// The number whose little-endian bytes are at, at + 1, ...
template <typename Number>
Number counting(std::uint8_t at) {
  std::array<std::uint8_t, sizeof(Number)> raw{};
  for (std::uint8_t& byte : raw) byte = at++;
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(raw);
  return std::bit_cast<Number>(raw);
}

TEST_CASE("attributes of the formats 0 to 5") {
  const std::string_view flags =
      " return_number number_of_returns scan_direction edge_of_flight_line classification "
      "classification_flags";
  for (unsigned format = 0; format <= 5; ++format) {
    CAPTURE(format);
    const PointFile file = read(las_of_format(format));
    CHECK(file.points == std::vector<Point3>{{1, -2, 3}});
    CHECK(file.precision == Precision::kDouble);
    const bool has_time = format == 1 || format >= 3;
    const bool has_colours = format == 2 || format == 3 || format == 5;
    CHECK(attribute_names(file) == std::string("intensity scan_angle user_data point_source_id") +
                                       (has_time ? " gps_time" : "") +
                                       (has_colours ? " red green blue" : "") + std::string(flags));
    CHECK(has_values<std::uint16_t>(file, "intensity", {0x0D0C}));
    CHECK(has_values<std::uint8_t>(file, "return_number", {0x0E & 7}));
    CHECK(has_values<std::uint8_t>(file, "number_of_returns", {0x0E >> 3}));
    CHECK(has_values<std::uint8_t>(file, "classification", {0x0F}));
    CHECK(has_values<std::int8_t>(file, "scan_angle", {0x10}));
    CHECK(has_values<std::uint8_t>(file, "user_data", {0x11}));
    CHECK(has_values<std::uint16_t>(file, "point_source_id", {0x1312}));
    if (has_time) CHECK(has_values<double>(file, "gps_time", {counting<double>(20)}));
    const std::uint8_t red_at = format == 2 ? 20 : 28;
    if (!has_colours) continue;
    CHECK(has_values<std::uint16_t>(file, "red", {counting<std::uint16_t>(red_at)}));
    CHECK(has_values(file, "blue", std::vector{counting<std::uint16_t>(red_at + 4)}));
  }
}

TEST_CASE("attributes of the formats 6 to 10") {
  for (unsigned format = 6; format <= 10; ++format) {
    CAPTURE(format);
    const PointFile file = read(las_of_format(format));
    CHECK(file.points == std::vector<Point3>{{1, -2, 3}});
    const bool has_colours = format == 7 || format == 8 || format == 10;
    const bool has_infrared = format == 8 || format == 10;
    CHECK(attribute_names(file) ==
          std::string("intensity classification user_data scan_angle point_source_id gps_time") +
              (has_colours ? " red green blue" : "") + (has_infrared ? " nir" : "") +
              " return_number number_of_returns classification_flags scanner_channel "
              "scan_direction edge_of_flight_line");
    CHECK(has_values<std::uint8_t>(file, "return_number", {0x0E}));
    CHECK(has_values<std::uint8_t>(file, "number_of_returns", {0}));
    CHECK(has_values<std::uint8_t>(file, "classification_flags", {0x0F}));
    CHECK(has_values<std::uint8_t>(file, "classification", {0x10}));
    CHECK(has_values<std::uint8_t>(file, "user_data", {0x11}));
    CHECK(has_values<std::int16_t>(file, "scan_angle", {0x1312}));
    CHECK(has_values<std::uint16_t>(file, "point_source_id", {0x1514}));
    CHECK(has_values<double>(file, "gps_time", {counting<double>(22)}));
    if (has_colours) CHECK(has_values<std::uint16_t>(file, "red", {0x1F1E}));
    if (has_infrared) CHECK(has_values<std::uint16_t>(file, "nir", {0x2524}));
  }
}

TEST_CASE("bits of the flags") {
  Las las = las_of_format(0);
  las.records[14] = '\x6A';  // 0 1 101 010
  las.records[15] = '\xA3';  // 101 00011
  const PointFile old = read(las);
  CHECK(has_values<std::uint8_t>(old, "return_number", {2}));
  CHECK(has_values<std::uint8_t>(old, "number_of_returns", {5}));
  CHECK(has_values<std::uint8_t>(old, "scan_direction", {1}));
  CHECK(has_values<std::uint8_t>(old, "edge_of_flight_line", {0}));
  CHECK(has_values<std::uint8_t>(old, "classification", {3}));
  CHECK(has_values<std::uint8_t>(old, "classification_flags", {5}));
  las = las_of_format(6);
  las.records[14] = '\xC5';
  las.records[15] = '\xA9';  // 1 0 10 1001
  const PointFile late = read(las);
  CHECK(has_values<std::uint8_t>(late, "return_number", {5}));
  CHECK(has_values<std::uint8_t>(late, "number_of_returns", {12}));
  CHECK(has_values<std::uint8_t>(late, "classification_flags", {9}));
  CHECK(has_values<std::uint8_t>(late, "scanner_channel", {2}));
  CHECK(has_values<std::uint8_t>(late, "scan_direction", {0}));
  CHECK(has_values<std::uint8_t>(late, "edge_of_flight_line", {1}));
}

}  // namespace
}  // namespace tetsculpt
