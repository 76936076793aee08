// Ascii PLY: the header says where x, y and z are, and all else is skipped.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/io_files.h"
#include "tests/support/io_hard_points.h"
#include "tests/support/io_ply_bytes.h"

namespace tetsculpt {
namespace {

using testing::kXyzFloat;
using testing::ply_header;
using testing::read_content;
using testing::same_bits;

const std::vector<Point3> kExpected = {{1, 2, 3}, {-4, 5, 6.5}};

void check_vertices(std::string_view content, Precision precision) {
  CAPTURE(content);
  const PointFile file = read_content("a.ply", content);
  CHECK(file.precision == precision);
  CHECK(same_bits(file.points, kExpected));
}

TEST_CASE("plain, with faces that are not looked at") {
  check_vertices(ply_header("ascii", "element vertex 2\n" + std::string(kXyzFloat) +
                                         "element face 1\n"
                                         "property list uchar int vertex_indices\n") +
                     "1 2 3\n-4 5 6.5\n3 0 1 0\n",
                 Precision::kSingle);
}

TEST_CASE("line ends, blanks, comments in the header") {
  std::string content = ply_header("ascii",
                                   "comment made by hand\nobj_info num_cols 2\n\n"
                                   "element\tvertex  2 \n" +
                                       std::string(kXyzFloat)) +
                        "\n 1 2 3 \n\t-4 5 6.5";
  check_vertices(content, Precision::kSingle);
  std::string crlf;
  for (const char c : content) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  check_vertices(crlf, Precision::kSingle);
  std::ranges::replace(content, '\n', '\r');
  check_vertices(content, Precision::kSingle);
}

TEST_CASE("order, other properties, lists") {
  check_vertices(ply_header("ascii",
                            "element vertex 2\nproperty list uchar int ids\nproperty double z\n"
                            "property uchar red\nproperty double x\nproperty list int float w\n"
                            "property double y\nproperty float nx\n") +
                     "0 3 255 1 2 .1 .2 2 9\n3 7 7 7 6.5 0 -4 0 5 9\n",
                 Precision::kDouble);
}

TEST_CASE("elements before the vertices") {
  check_vertices(ply_header("ascii",
                            "element camera 1\nproperty float x\nproperty float y\n"
                            "element nothing 5\n"
                            "element strip 2\nproperty list int int ids\n"
                            "element vertex 2\n" +
                                std::string(kXyzFloat) + "element more 1\nproperty int x\n") +
                     "8 8\n0\n3 1 2 3\n1 2 3\n-4 5 6.5\n",
                 Precision::kSingle);
}

TEST_CASE("precision is single only if all three are floats") {
  const auto precision = [](const std::string& x, const std::string& y, const std::string& z) {
    return read_content("a.ply", ply_header("ascii", "element vertex 0\nproperty " + x +
                                                         " x\nproperty " + y + " y\nproperty " + z +
                                                         " z\nproperty double w\n"))
        .precision;
  };
  CHECK(precision("float", "float32", "float") == Precision::kSingle);
  CHECK(precision("float", "float", "double") == Precision::kDouble);
  CHECK(precision("int", "float", "float") == Precision::kDouble);
  CHECK(precision("uchar", "uchar", "uchar") == Precision::kDouble);
}

TEST_CASE("text of type float is rounded to a float, of type double to a double") {
  const std::string body = "0.1 16777217.00000000001 1e-45\n";
  const auto points = [&](std::string type) {
    return read_content("a.ply",
                        ply_header("ascii", "element vertex 1\nproperty " + type + " x\nproperty " +
                                                type + " y\nproperty " + type + " z\n") +
                            body)
        .points;
  };
  const double tiny = static_cast<double>(std::numeric_limits<float>::denorm_min());
  CHECK(same_bits(points("float"), std::vector<Point3>{{double{0.1F}, 16777218, tiny}}));
  CHECK(same_bits(points("double"), std::vector<Point3>{{0.1, 16777217.00000000001, 1e-45}}));
}

}  // namespace
}  // namespace tetsculpt
