// Whatever the bytes of a text file are: it is read, each attribute with a value per point, or
// refused with an IoError.
#include <doctest/doctest.h>

#include <filesystem>
#include <string_view>

#include "io/obj_reader.h"
#include "io/off_reader.h"
#include "io/pcd_reader.h"
#include "io/ply_reader.h"
#include "io/read_points.h"
#include "io/stl_reader.h"
#include "io/text_points.h"
#include "io/vtk_reader.h"
#include "tests/support/io_mutations.h"
#include "tests/support/io_ply_bytes.h"
#include "tests/support/io_point_attributes.h"

namespace tetsculpt {
namespace {

using testing::completely;
using testing::ply_header;
using testing::survives;

TEST_CASE("text") {
  const auto parse = [](std::string_view text, const std::filesystem::path& path) {
    return parse_text_points(text, path);
  };
  CHECK(survives("x,y,z\n2\n0.1,-2e5,3;\r\n# c\n 4\t5 nan 7\n", completely(parse)));
  CHECK(survives("//b;g;r;z;y;x\n2\n0;1;2;3;4;5\n0;;200;3;4;5\n", completely(parse)));
}

TEST_CASE("obj") {
  CHECK(survives("# c\nv 0 1.5 -2\nvn 0 0 1\nv 1 2 3 4\n", completely(parse_obj_points)));
  CHECK(survives("v 0 1.5 -2 1 0 .5\nv 1 2 3 255 0 1\n", completely(parse_obj_points)));
}

TEST_CASE("off") {
  CHECK(survives("COFF 2 1 0 # c\n0 1 2 9\n\n1 1 1 9\n", completely(parse_off_points)));
  CHECK(survives("STCNOFF\n2\n0 1 2 0 0 1 9 9 9 9 .5 .5\n1 1 1 0 1 0 1 2 3 4 0 1\n",
                 completely(parse_off_points)));
}

TEST_CASE("ply ascii") {
  CHECK(survives(
      ply_header("ascii",
                 "element a 2\nproperty list uchar short i\nelement vertex 3\nproperty float x\n"
                 "property double y\nproperty list char uchar w\nproperty int z\n"
                 "property uchar red\n") +
          "1 7\n0\n0.5 0.1 2 9 9 7 1\n1 2 0 3 2\n\n-1 -2 1 8 -3 3\n",
      completely(parse_ply_points)));
}

TEST_CASE("stl") {
  CHECK(
      survives("solid a\nfacet normal 0 0 1\nouter loop\nvertex 1 2 3\nvertex 4 5 6\nvertex 7 8 9\n"
               "endloop\nendfacet\nendsolid a\n",
               completely(parse_stl_points)));
}

TEST_CASE("vtk") {
  CHECK(
      survives("# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n"
               "1 2 3 4 5 6\nVERTICES 1 3\n2 0 1\nPOINT_DATA 2\nSCALARS s int 1\n"
               "LOOKUP_TABLE d\n7 8\nFIELD f 1\na 2 2 float\n1 2 3 4\nNORMALS n float\n"
               "0 0 1 0 0 1\n",
               completely(parse_vtk_points)));
}

TEST_CASE("pcd") {
  CHECK(
      survives("VERSION .7\nFIELDS x y z rgb f\nSIZE 4 8 2 4 1\nTYPE F F I U U\nCOUNT 1 1 1 1 2\n"
               "WIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n1 2 3 4 5 6\n1e-3 nan 3 400 5 6\n",
               completely(parse_pcd_points)));
}

TEST_CASE("whatever the content is taken for") {
  const auto parse = [](std::string_view content, const std::filesystem::path&) {
    return parse_points(content, "standard input");
  };
  for (const char* content : {"1 2 3\n4 5 6\n", "OFF 1 0 0\n1 2 3\n", "v 1 2 3\n",
                              "solid\nendsolid\n", "# c\nx y z r\n1 2 3 4\n"}) {
    CHECK(survives(content, completely(parse)));
  }
}

}  // namespace
}  // namespace tetsculpt
