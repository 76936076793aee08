// Broken and compressed LAS files are refused by name, with the byte of the fault.
#include <doctest/doctest.h>

#include <string>

#include "tests/support/io_files.h"
#include "tests/support/io_las_bytes.h"

namespace tetsculpt {
namespace {

using testing::Las;
using testing::las_bytes;
using testing::las_record;
using testing::refusal;

Las valid() {
  Las las;
  las.short_count = 2;
  las.records = las_record(20, {1, 2, 3}) + las_record(20, {4, 5, 6});
  return las;
}

Las valid_new() {
  Las las = valid();
  las.minor = 4;
  las.header_size = 375;
  las.points_at = 375;
  las.long_count = 2;
  return las;
}

std::string refused(const Las& las) { return refusal("a.las", las_bytes(las)); }

TEST_CASE("valid") {
  CHECK(refused(valid()) == "read");
  CHECK(refused(valid_new()) == "read");
}

TEST_CASE("cut off anywhere") {
  CHECK(refusal("a.las", "LAS") == "not a LAS file");
  CHECK(refusal("a.las", "LASF") == "byte 4: the file ends within the header");
  const std::string file = las_bytes(valid());
  CHECK(refusal("a.las", file.substr(0, 226)) == "byte 226: the file ends within the header");
  CHECK(refusal("a.las", file.substr(0, 227)) ==
        "byte 227: points: 2 of 20 bytes announced, 0 bytes left");
  CHECK(refusal("a.las", file.substr(0, file.size() - 1)) ==
        "byte 227: points: 2 of 20 bytes announced, 39 bytes left");
  const std::string late = las_bytes(valid_new());
  CHECK(refusal("a.las", late.substr(0, 374)) == "byte 374: the file ends within the header");
}

TEST_CASE("compressed") {
  for (const unsigned bits : {0x80U, 0x40U, 0xC0U}) {
    Las las = valid();
    las.format = 3 | bits;
    CHECK(refused(las) ==
          "the points are compressed (LAZ): decompress them first, for example with laszip");
  }
}

TEST_CASE("header") {
  Las las = valid();
  las.minor = 5;
  CHECK(refused(las) == "byte 24: LAS version 1.5; 1.0 to 1.4 are read");
  las = valid();
  las.header_size = 226;
  CHECK(refused(las) == "byte 94: a header of 226 bytes; this version has 227");
  las = valid_new();
  las.header_size = 227;
  CHECK(refused(las) == "byte 94: a header of 227 bytes; this version has 375");
  las = valid();
  las.header_size = 228;
  CHECK(refused(las) == "byte 96: the points begin within the header");
  las = valid();
  las.format = 11;
  CHECK(refused(las) == "byte 104: unknown point format 11; 0 to 10 are read");
  las = valid();
  las.format = 1;
  CHECK(refused(las) == "byte 105: records of 20 bytes; point format 1 has 28");
}

TEST_CASE("counts") {
  Las las = valid();
  las.short_count = 4294967295U;
  CHECK(refused(las) == "byte 227: points: 4294967295 of 20 bytes announced, 40 bytes left");
  las = valid_new();
  las.short_count = 0;
  las.long_count = 18446744073709551615U;
  CHECK(refused(las) ==
        "byte 375: points: 18446744073709551615 of 20 bytes announced, 40 bytes left");
  las.short_count = 2;
  CHECK(refused(las) == "byte 247: two counts of points that differ: 2 and 18446744073709551615");
}

TEST_CASE("points beyond the end of the file") {
  std::string file = las_bytes(valid());
  testing::put(file, 96, testing::bytes(std::uint32_t{4000000000U}, std::endian::little));
  CHECK(refusal("a.las", file) == "byte 267: points: 2 of 20 bytes announced, 0 bytes left");
}

}  // namespace
}  // namespace tetsculpt
