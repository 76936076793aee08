// LAS: coordinates as the standard says, wherever the header puts the points, in every version.
#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

#include "tests/support/io_files.h"
#include "tests/support/io_hard_points.h"
#include "tests/support/io_las_bytes.h"

namespace tetsculpt {
namespace {

using testing::Las;
using testing::las_bytes;
using testing::las_of_format;
using testing::las_record;
using testing::read_content;
using testing::same_bits;

PointFile read(const Las& las) { return read_content("a.las", las_bytes(las)); }

TEST_CASE("coordinates: product and sum are each rounded") {
  Las las = las_of_format(0);
  las.scale = {0.01, 1e-3, -0.25};
  las.offset = {500000.1, -1e6 / 3, 0.1};
  las.records = las_record(20, {123456789, INT32_MIN, INT32_MAX});
  const volatile double x = 123456789 * 0.01;
  const volatile double y = -2147483648.0 * 1e-3;
  const volatile double z = 2147483647 * -0.25;
  CHECK(same_bits(read(las).points, std::vector<Point3>{{x + 500000.1, y + -1e6 / 3, z + 0.1}}));
}

TEST_CASE("longer headers and records, what is between and behind") {
  Las las = las_of_format(3);
  las.header_size = 300;
  las.points_at = 1000;
  las.record_size = 40;
  las.short_count = 2;
  las.records = las_record(40, {1, 2, 3}) + las_record(40, {4, 5, 6}) + "behind";
  CHECK(read(las).points == std::vector<Point3>{{1, 2, 3}, {4, 5, 6}});
}

TEST_CASE("versions and their counts") {
  for (const unsigned minor : {0U, 1U, 2U, 3U}) {
    Las las = las_of_format(0);
    las.minor = minor;
    CHECK(read(las).points.size() == 1);
  }
  Las las = las_of_format(0);
  las.minor = 4;
  las.header_size = 375;
  las.points_at = 375;
  CHECK(read(las).points.size() == 1);  // the short count alone
  las.long_count = 1;
  CHECK(read(las).points.size() == 1);
  las.short_count = 0;
  CHECK(read(las).points.size() == 1);
  las.long_count = 0;
  CHECK(read(las).points.empty());
}

}  // namespace
}  // namespace tetsculpt
