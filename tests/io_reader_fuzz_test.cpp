// Whatever the bytes of a file are: it is read, or refused with an IoError.
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/obj_reader.h"
#include "io/off_reader.h"
#include "io/ply_reader.h"
#include "io/text_points.h"
#include "tests/support/io_mutations.h"
#include "tests/support/io_ply_bytes.h"

namespace tetsculpt {
namespace {

using testing::bytes;
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

TEST_CASE("text") {
  CHECK(survives("x,y,z\n2\n0.1,-2e5,3;\r\n# c\n 4\t5 nan 7\n", parse_text_points));
}

TEST_CASE("obj") { CHECK(survives("# c\nv 0 1.5 -2\nvn 0 0 1\nv 1 2 3 4\n", parse_obj_points)); }

TEST_CASE("off") { CHECK(survives("COFF 2 1 0 # c\n0 1 2 9\n\n1 1 1 9\n", parse_off_points)); }

TEST_CASE("ply ascii") {
  CHECK(survives(
      ply_header("ascii", kElements) + "1 7\n0\n0.5 0.1 2 9 9 7\n1 2 0 3\n\n-1 -2 1 8 -3\n",
      parse_ply_points));
}

TEST_CASE("ply binary") {
  CHECK(survives(binary_ply(std::endian::little, "binary_little_endian"), parse_ply_points));
  CHECK(survives(binary_ply(std::endian::big, "binary_big_endian"), parse_ply_points));
}

}  // namespace
}  // namespace tetsculpt
