// Whatever the bytes of a mesh file are: it is read with all indices in range, or refused with an
// IoError.
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <string>

#include "io/base64.h"
#include "io/read_mesh.h"
#include "tests/support/io_gltf_bytes.h"
#include "tests/support/io_mutations.h"
#include "tests/support/io_ply_bytes.h"

namespace tetsculpt {
namespace {

using testing::bytes;

bool survives(const std::string& name, const std::string& file) {
  return testing::survives(file, [&](std::string_view content, const char*) {
    const TriangleMesh mesh = parse_mesh(content, name).mesh;
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t v : triangle) {
        if (v >= mesh.points.size()) throw std::out_of_range("index");
      }
    }
  });
}

std::string big(std::initializer_list<int> values) {
  std::string text;
  for (const int value : values) text += bytes(std::int32_t{value}, std::endian::big);
  return text;
}

TEST_CASE("ply") {
  const std::string elements =
      "element vertex 3\nproperty char x\nproperty char y\nproperty char z\nelement face 2\n"
      "property uchar r\nproperty list uchar char vertex_indices\nproperty list uchar char w\n";
  CHECK(survives("a.ply", testing::ply_header("ascii", elements) +
                              "0 0 0\n1 0 0\n0 1 0\n7 3 0 1 2 0\n7 4 0 1 2 1 1 5\n"));
  CHECK(survives(
      "a.ply", testing::ply_header("binary_big_endian", elements) + std::string("\0\0\0\1\0\0\0\1\0"
                                                                                "\7\3\0\1\2\0"
                                                                                "\7\4\0\1\2\1\1\5",
                                                                                23)));
}

TEST_CASE("obj") {
  CHECK(survives("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/2 2//3 -1\nf 1 2 3 1\n"));
}

TEST_CASE("off") {
  CHECK(survives("a.off", "OFF 3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n4 0 1 2 1 9\n"));
}

TEST_CASE("stl") {
  CHECK(survives("a.stl",
                 "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                 "vertex 0 1 0\nendloop\nendfacet\nendsolid\n"));
}

TEST_CASE("vtk") {
  const std::string head = "# vtk DataFile Version 3.0\nt\n";
  CHECK(survives("a.vtk", head + "ASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n"
                                 "POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 3\n"));
  CHECK(survives("a.vtk", head + "BINARY\nDATASET POLYDATA\nPOINTS 3 char\n" + "000100010" +
                              "\nPOLYGONS 1 4\n" + big({3, 0, 1, 2}) + "\nLINES 1 2\n" +
                              big({1, 1})));
  CHECK(survives("a.vtk", head + "BINARY\nDATASET POLYDATA\nPOINTS 3 char\n" + "000100010" +
                              "\nPOLYGONS 2 3\nOFFSETS int\n" + big({0, 3}) +
                              "\nCONNECTIVITY int\n" + big({0, 1, 2})));
}

TEST_CASE("vrml") {
  CHECK(survives("a.wrl",
                 "#VRML V2.0 utf8\nShape{geometry IndexedFaceSet{coord Coordinate{point[0 0 "
                 "0,1 0 0,0 1 0]}coordIndex[0 1 2 -1 2,1,0,0]ccw FALSE}}\n"));
}

TEST_CASE("gltf") {
  CHECK(
      survives("a.glb", testing::tetrahedron_glb(
                            R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[1,2,-3]}])")));
  CHECK(survives(
      "a.gltf", testing::tetrahedron_json(testing::kTetrahedronMesh,
                                          "data:;base64," + base64(testing::kTetrahedronPoints +
                                                                   testing::kTetrahedronCorners))));
}

}  // namespace
}  // namespace tetsculpt
