// Point texts of every dialect give the same points.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/io_files.h"
#include "tests/support/io_hard_points.h"

namespace tetsculpt {
namespace {

using testing::read_content;
using testing::same_bits;

const std::vector<Point3> kExpected = {{1, 2, 3}, {-0.5, 1e3, 0.25}};

void check_dialect(std::string_view name, std::string_view text) {
  CAPTURE(name);
  CAPTURE(text);
  const PointFile file = read_content(name, text);
  CHECK(file.precision == Precision::kDouble);
  CHECK(same_bits(file.points, kExpected));
}

TEST_CASE("separators") {
  check_dialect("a.xyz", "1 2 3\n-0.5 1e3 0.25\n");
  check_dialect("a.csv", "1,2,3\n-0.5,1e3,.25\n");
  check_dialect("a.txt", "1;2;3\n-0.5; 1e3;\t0.25\n");
  check_dialect("a.asc", " \t1\t2 , 3 \n  -0.5\t\t+1E+3 2.5e-1\t\n");
  check_dialect("a.XYZ", "1 2 3\n-0.5 1e3 0.25\n");
}

TEST_CASE("further columns do not count") {
  check_dialect("a.pts", "1 2 3 255 0 0\n-0.5 1e3 0.25 17 note 4\n");
  check_dialect("a.csv", "1,2,3,\n-0.5,1000,0.25,\"a, b\"\n");
}

TEST_CASE("blank lines and comments") {
  check_dialect("a.xyz", "\n# x y z\n1 2 3\n \t\n  // half\n-0.5 1e3 0.25\n\n#end");
}

TEST_CASE("line ends") {
  check_dialect("a.xyz", "1 2 3\n-0.5 1e3 0.25");
  check_dialect("a.xyz", "1 2 3\r\n-0.5 1e3 0.25\r\n");
  check_dialect("a.xyz", "1 2 3\r-0.5 1e3 0.25\r");
  check_dialect("a.xyz", "1 2 3\n-0.5 1e3 0.25\r");
  check_dialect("a.xyz", "\r\r\n1 2 3\n\r-0.5 1e3 0.25\n\n\r");
}

TEST_CASE("byte order mark") {
  check_dialect("a.txt",
                "\xEF\xBB\xBF"
                "1 2 3\n-0.5 1e3 0.25\n");
  check_dialect("a.csv", "\xEF\xBB\xBFx,y,z\n1,2,3\n-0.5,1e3,0.25\n");
}

TEST_CASE("header lines before the first point") {
  check_dialect("a.csv", "x,y,z\n1,2,3\n-0.5,1e3,0.25\n");
  check_dialect("a.csv", "\"X\" \"Y\" \"Z\"\n1,2,3\n-0.5,1e3,0.25\n");
  check_dialect("a.txt", "info nanometres z\n1 2 3\n-0.5 1e3 0.25\n");
  check_dialect("a.pts", "2\n1 2 3\n-0.5 1e3 0.25\n");
  check_dialect("a.asc", "//X Y Z\n2\n1 2 3\n-0.5 1e3 0.25\n");
  check_dialect("a.xyz", "2\r\nfrom a scan\r\n1 2 3\r\n-0.5 1e3 0.25\r\n");
}

TEST_CASE("no points") {
  for (const char* text : {"", "\n", "\r", "# nothing", "x,y,z\n", "0\n", "\xEF\xBB\xBF"}) {
    CAPTURE(text);
    CHECK(read_content("a.csv", text).points.empty());
  }
}

TEST_CASE("values that are not finite are passed on") {
  const std::vector<Point3> points =
      read_content("a.xyz", "nan inf -inf\n0 -Infinity NaN\n").points;
  REQUIRE(points.size() == 2);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  CHECK(std::isnan(points[0].x));
  CHECK(points[0].y == kInfinity);
  CHECK(points[0].z == -kInfinity);
  CHECK(points[1].y == -kInfinity);
  CHECK(std::isnan(points[1].z));
}

TEST_CASE("many lines that end with a carriage return") {
  constexpr int kLines = 200'000;
  std::string text;
  for (int i = 0; i < kLines; ++i) text += "0 0 1\r";
  CHECK(read_content("a.xyz", text).points.size() == kLines);
}

}  // namespace
}  // namespace tetsculpt
