// Whatever the bytes of a binary file are: it is read, each attribute with a value per point, or
// refused with an IoError.
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/las_reader.h"
#include "io/pcd_reader.h"
#include "io/ply_reader.h"
#include "io/stl_reader.h"
#include "io/vtk_reader.h"
#include "tests/support/io_las_bytes.h"
#include "tests/support/io_mutations.h"
#include "tests/support/io_ply_bytes.h"
#include "tests/support/io_point_attributes.h"

namespace tetsculpt {
namespace {

using testing::bytes;
using testing::completely;
using testing::ply_header;
using testing::survives;

// Small counts, so that most of the numbers in a file matter.
constexpr std::string_view kElements =
    "element a 2\nproperty list uchar short i\nelement vertex 3\nproperty float x\n"
    "property double y\nproperty list char uchar w\nproperty int z\n";

std::string binary_ply(std::endian order, std::string_view format) {
  std::string file = ply_header(format, kElements);
  for (const std::int16_t item : {std::int16_t{4}, std::int16_t{-5}}) {
    file += bytes(std::uint8_t{1}, order) + bytes(item, order);
  }
  for (const std::int32_t z : {7, -8, 9}) {
    file += bytes(0.5F, order) + bytes(0.1, order) + "\x02vw" + bytes(z, order);
  }
  return file;
}

TEST_CASE("ply") {
  CHECK(survives(binary_ply(std::endian::little, "binary_little_endian"),
                 completely(parse_ply_points)));
  CHECK(survives(binary_ply(std::endian::big, "binary_big_endian"), completely(parse_ply_points)));
}

TEST_CASE("stl") {
  CHECK(survives(std::string(80, ' ') + bytes(std::uint32_t{2}, std::endian::little) +
                     std::string(100, '\x3F'),
                 completely(parse_stl_points)));
}

TEST_CASE("pcd") {
  const std::string header =
      "VERSION .7\nFIELDS x y z rgb f\nSIZE 4 8 2 4 1\nTYPE F F I U U\nCOUNT 1 1 1 1 2\n"
      "WIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ";
  const std::string data(40, '\x3F');
  CHECK(survives(header + "binary\n" + data, completely(parse_pcd_points)));
  CHECK(survives(header + "binary_compressed\n" + bytes(std::uint32_t{10}, std::endian::little) +
                     bytes(std::uint32_t{40}, std::endian::little) + "\2abc\xE0\x1A\2\1??",
                 completely(parse_pcd_points)));
}

TEST_CASE("las") {
  for (const unsigned minor : {2U, 4U}) {
    testing::Las las;
    las.minor = minor;
    las.format = minor == 2 ? 3 : 8;
    las.record_size = minor == 2 ? 34 : 38;
    las.header_size = minor == 2 ? 227 : 375;
    las.points_at = las.header_size;
    las.short_count = minor == 2 ? 2 : 0;
    las.long_count = 2;
    las.records = testing::las_record(las.record_size, {1, 2, 3}) +
                  testing::las_record(las.record_size, {4, 5, 6});
    CHECK(survives(testing::las_bytes(las), completely(parse_las_points)));
  }
}

TEST_CASE("vtk") {
  CHECK(survives("# vtk DataFile Version 3.0\nt\nBINARY\nDATASET POLYDATA\nPOINTS 2 float\n" +
                     std::string(24, '?') + "\nLINES 1 3\n" + std::string(12, '?') +
                     "\nPOINT_DATA 2\nCOLOR_SCALARS c 3\nabcdef\nFIELD f 1\nb 1 2 bit\n?\n",
                 completely(parse_vtk_points)));
}

}  // namespace
}  // namespace tetsculpt
