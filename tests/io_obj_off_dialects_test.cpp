// OBJ and OFF: every usual form of header, vertex and comment gives the same vertices.
#include <doctest/doctest.h>

#include <string_view>
#include <vector>

#include "tests/support/io_files.h"
#include "tests/support/io_hard_points.h"

namespace tetsculpt {
namespace {

using testing::read_content;
using testing::same_bits;

const std::vector<Point3> kExpected = {{0, 0, 0}, {1, -0.0, 0.5}, {1e-3, 1, 2}};

void check_vertices(std::string_view name, std::string_view text) {
  CAPTURE(text);
  const PointFile file = read_content(name, text);
  CHECK(file.precision == Precision::kDouble);
  CHECK(same_bits(file.points, kExpected));
}

TEST_CASE("obj: only the lines v count") {
  check_vertices("a.obj",
                 "# a comment\nmtllib a.mtl\no thing\n"
                 "v 0 0 0\nv 1 -0 0.5\nvn 0 0 1\nvt 0 0\nv 1e-3 1 2\n"
                 "f 1//1 2//1 3//1\nvp 1 2\nv2 4 4 4\n");
}

TEST_CASE("obj: weights, colours, blanks, line ends") {
  check_vertices("a.OBJ", "\tv\t0 0 0 1.0\r\n\r\n v  1 -0 .5 0.1 0.2 0.3\r\nv +1e-3 1 2\r");
}

TEST_CASE("obj: no vertices") { CHECK(read_content("a.obj", "o nothing\n").points.empty()); }

TEST_CASE("off: places of the counts") {
  check_vertices("a.off", "OFF\n3 1 0\n0 0 0\n1 -0 .5\n1e-3 1 2\n3 0 1 2\n");
  check_vertices("a.off", "OFF 3 1 0\n0 0 0\n1 -0 .5\n1e-3 1 2\n3 0 1 2\n");
  check_vertices("a.off", "OFF3 1 0\n0 0 0\n1 -0 .5\n1e-3 1 2\n3 0 1 2\n");
  check_vertices("a.off", "OFF\n3\n0 0 0\n1 -0 .5\n1e-3 1 2");
  check_vertices("a.Off", "\xEF\xBB\xBFOFF\r\n3 0 0\r\n0 0 0\r\n1 -0 .5\r\n1e-3 1 2\r\n");
}

TEST_CASE("off: comments and blank lines") {
  check_vertices("a.off",
                 "# before\n\nOFF # the keyword\n# between\n3 1 0 # counts\n\n"
                 "0 0 0 # origin\n  # more\n1 -0 .5\n1e-3 1 2\n3 0 1 2\n");
}

TEST_CASE("off: vertices with more data") {
  check_vertices("a.off", "COFF\n3 0 0\n0 0 0 255 0 0 255\n1 -0 .5 1 1 1 1\n1e-3 1 2 0 0 0 0\n");
  check_vertices("a.off", "NOFF\n3 0 0\n0 0 0 0 0 1\n1 -0 .5 0 0 1\n1e-3 1 2 0 0 1\n");
  check_vertices("a.off", "STOFF\n3 0 0\n0 0 0 .1 .2\n1 -0 .5 .1 .2\n1e-3 1 2 .1 .2\n");
  check_vertices("a.off", "STCNOFF 3 0 0\n0 0 0 7\n1 -0 .5 7\n1e-3 1 2 7\n");
}

TEST_CASE("off: no vertices") { CHECK(read_content("a.off", "OFF\n0 0 0\n").points.empty()); }

}  // namespace
}  // namespace tetsculpt
