// STL: the corners of the triangles, from text and from binary, whichever the name or `solid` says.
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/io_files.h"
#include "tests/support/io_hard_points.h"
#include "tests/support/io_ply_bytes.h"

namespace tetsculpt {
namespace {

using testing::bytes;
using testing::read_content;
using testing::refusal;
using testing::same_bits;

// Corners are 1, 2, 3, ... in each coordinate; `title` begins the 80 free bytes.
std::string binary(std::uint32_t announced, std::uint32_t triangles, std::string title) {
  title.resize(80, '\0');
  std::string file = title + bytes(announced, std::endian::little);
  float next = 1;
  for (std::uint32_t i = 0; i < triangles; ++i) {
    file += std::string(12, '\x7F');
    for (int k = 0; k < 9; ++k) file += bytes(next++, std::endian::little);
    file += "\xFF\xFF";
  }
  return file;
}

const std::vector<Point3> kCorners = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};

constexpr std::string_view kText =
    "solid a name of words\n facet normal 0 0 1\n  outer loop\n   vertex 1 2 3\n"
    "   vertex 4 5 6\n   vertex 7 8 9\n  endloop\n endfacet\nendsolid a name of words\n";

TEST_CASE("binary") {
  for (const char* title : {"", "solid", "solid name\nfacet normal", "made by hand"}) {
    CAPTURE(title);
    const PointFile file = read_content("a.stl", binary(1, 1, title));
    CHECK(file.precision == Precision::kSingle);
    CHECK(file.attributes.empty());
    CHECK(same_bits(file.points, kCorners));
  }
  CHECK(read_content("a.stl", binary(3, 3, "x")).points.size() == 9);
  CHECK(read_content("a.stl", binary(0, 0, "x")).points.empty());
  CHECK(read_content("a.stl", binary(1, 1, "x") + "\r\n").points.size() == 3);
}

TEST_CASE("binary: values that are not finite are passed on") {
  std::string file = binary(1, 1, "");
  file.replace(84 + 12, 4, bytes(std::numeric_limits<float>::infinity(), std::endian::little));
  CHECK(read_content("a.stl", file).points[0].x == std::numeric_limits<double>::infinity());
}

TEST_CASE("binary: a count that does not hold") {
  CHECK(refusal("a.stl", binary(2, 1, "")) ==
        "byte 80: not an STL file, or cut off: triangles announced: 2, room for: 1");
  CHECK(refusal("a.stl", binary(4294967295U, 1, "solid")) ==
        "byte 80: not an STL file, or cut off: triangles announced: 4294967295, room for: 1");
  CHECK(refusal("a.stl", binary(0, 2, "")) ==
        "byte 80: not an STL file, or cut off: triangles announced: 0, room for: 2");
  CHECK(refusal("a.stl", "short") == "not an STL file");
  CHECK(refusal("a.stl", "") == "not an STL file");
}

TEST_CASE("text") {
  const PointFile file = read_content("a.stl", kText);
  CHECK(file.precision == Precision::kDouble);
  CHECK(same_bits(file.points, kCorners));
  CHECK(read_content("a.stl", "solid\nendsolid\n").points.empty());
  CHECK(read_content("a.stl", std::string(kText) + std::string(kText)).points.size() == 6);
}

TEST_CASE("text: case, blanks, line ends, no name, all in one line, odd normals") {
  CHECK(
      same_bits(read_content("a.stl",
                             "\xEF\xBB\xBF SOLID\r\nFACET NORMAL nan -nan(ind) 0\r\nOUTER LOOP\r\n"
                             "Vertex\t1 2 3\r\nVERTEX 4 5 6\r\n\r\nvertex +7 8e0 9.0\r\nENDLOOP\r\n"
                             "ENDFACET\r\nENDSOLID")
                    .points,
                kCorners));
  CHECK(same_bits(read_content("a.stl",
                               "solid\nfacet normal 0 0 1 outer loop vertex 1 2 3 vertex 4 5 6 "
                               "vertex 7\n8 9 endloop endfacet endsolid")
                      .points,
                  kCorners));
}

TEST_CASE("text: broken") {
  const std::string text(kText);
  CHECK(refusal("a.stl", text.substr(0, text.find("endloop"))) ==
        "7: the file ends within a solid");
  CHECK(refusal("a.stl", text.substr(0, text.find("endsolid"))) ==
        "8: the file ends within a solid");
  CHECK(refusal("a.stl", text.substr(0, text.find("7 8"))) == "6: the file ends within a solid");
  CHECK(refusal("a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 1 2\nvertex 1 2 3\n") ==
        "5: expected a number, found 'vertex'");
  CHECK(refusal("a.stl", "solid\nfacet normal 0 0 1\nouter loop\nendloop\n") ==
        "4: expected vertex");
  CHECK(refusal("a.stl", "solid a\nvertex 1 2 3\n") == "2: expected facet or endsolid");
  CHECK(refusal("a.stl", "solid a\nendsolid a\nmore\n") == "3: expected solid");
  CHECK(refusal("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 1 2 1e999\n") ==
        "4: number out of range: '1e999'");
}

}  // namespace
}  // namespace tetsculpt
