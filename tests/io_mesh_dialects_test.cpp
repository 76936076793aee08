// The forms in which meshes come: each of these files holds the same square of two triangles.
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/io_meshes.h"
#include "tests/support/io_ply_bytes.h"
#include "tests/support/meshes.h"

namespace tetsculpt {
namespace {

using testing::bytes;
using testing::mesh_from;

const std::vector<Point3> kSquare = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0.5}};
const testing::Triangles kFan = {{0, 1, 2}, {0, 2, 3}};

void check_square(const std::string& name, const std::string& content) {
  INFO(name << ": " << content);
  const TriangleMesh mesh = mesh_from(name, content).mesh;
  CHECK(mesh.points == kSquare);
  CHECK(mesh.triangles == kFan);
}

const std::string kRows = "0 0 0\n2 0 0\n2 2 0\n0 2 .5\n";

TEST_CASE("PLY: any type of list, other elements and properties around it") {
  const std::string vertices =
      "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
  for (const char* list : {"uchar int vertex_indices", "int uint vertex_index",
                           "char uchar vertex_indices", "uint8 double vertex_indices"}) {
    const std::string faces = std::string("element face 1\nproperty list ") + list + "\n";
    check_square("a.ply", testing::ply_header("ascii", vertices + faces) + kRows + "4 0 1 2 3\n");
    // A list of colours before, an element between, the face before the vertices.
    const std::string more =
        "element face 1\nproperty uchar red\nproperty list uchar float texcoord\nproperty list " +
        std::string(list) + "\nproperty int flags\nelement mark 2\nproperty list uchar int m\n";
    check_square("a.ply", testing::ply_header("ascii", more + vertices) +
                              "9 2 .5 .5 4 0 1 2 3 -1\n1 7\n0\n" + kRows);
  }
}

template <typename Index>
std::string binary_ply(std::endian order, const std::string& type) {
  std::string file =
      testing::ply_header(testing::format_name(order),
                          "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                          "element edge 1\nproperty list uchar short w\n"
                          "element face 2\nproperty uchar red\nproperty list ushort " +
                              type + " vertex_indices\nproperty list uchar float texcoord\n");
  for (const Point3& p : kSquare) {
    for (const double x : {p.x, p.y, p.z}) file += bytes(static_cast<float>(x), order);
  }
  file += bytes(std::uint8_t{1}, order) + bytes(std::int16_t{5}, order);
  for (const auto& triangle : kFan) {
    file += bytes(std::uint8_t{255}, order) + bytes(std::uint16_t{3}, order);
    for (const std::uint32_t v : triangle) file += bytes(static_cast<Index>(v), order);
    file += bytes(std::uint8_t{1}, order) + bytes(0.5F, order);
  }
  return file;
}

TEST_CASE("PLY: both binary orders") {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    check_square("a.ply", binary_ply<std::int32_t>(order, "int"));
    check_square("a.ply", binary_ply<std::uint8_t>(order, "uchar"));
    check_square("a.ply", binary_ply<double>(order, "double"));
  }
}

TEST_CASE("OBJ: all forms of corners, from both ends, faces before vertices") {
  const std::string v = "v 0 0 0\nv 2 0 0 1.0\nv 2 2 0\nv 0 2 0.5\n";
  for (const char* f : {"f 1 2 3 4\n", "f 1/1 2/7 3/5 4/1\n", "f 1//1 2//1 3//1 4//1\n",
                        "f 1/1/1 2/2/2 3/3/3 4/4/4\r\n", "f -4 -3 -2 -1 # all\n",
                        "g a\nusemtl b\ns off\nf 1 2 3\nf -4/1 3// 4\n"}) {
    check_square("a.obj", "# c\nvt 0 0\nvn 0 0 1\n" + v + f);
  }
  check_square("a.obj", "f 1 2 3 4\n" + v);
}

TEST_CASE("OFF: with colours and other data") {
  check_square("a.off", "OFF\n4 1 0\n" + kRows + "4 0 1 2 3\n");
  check_square("a.off",
               "OFF 4 2 # c\n\n" + kRows + "# c\n3 0 1 2 255 0 0\n\n3 0 2 3 0.5 0.5 0.5\n");
  check_square("a.off",
               "COFF\n4 1 0\n0 0 0 9 9 9 9\n2 0 0 9 9 9 9\n2 2 0 9 9 9 9\n0 2 .5 9 9 9 9\n"
               "4 0 1 2 3\n");
}

TEST_CASE("STL: text in any case, several solids, both line ends") {
  const std::string a =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 2 2 0\n"
      "endloop\nendfacet\n";
  const std::string b =
      "  FACET NORMAL 0 0 0\r\n OUTER LOOP\r\n VERTEX 0 0 -0.0\r\n VERTEX 2 2 0\r\n"
      " VERTEX 0 2 5e-1\r\n ENDLOOP\r\n ENDFACET\r\n";
  check_square("a.stl", "solid a b c\n" + a + b + "endsolid a b c\n");
  check_square("a.stl", "SOLID\n" + a + "ENDSOLID\n\nsolid\n" + b + "endsolid");
}

TEST_CASE("STL: binary that begins with solid") {
  std::string file = "solid";
  file.resize(80, ' ');
  file += bytes(std::uint32_t{2}, std::endian::little);
  for (const auto& triangle : kFan) {
    file += std::string(12, '\0');
    for (const std::uint32_t v : triangle) {
      const Point3& p = kSquare[v];
      for (const double x : {p.x, p.y, p.z}) {
        file += bytes(static_cast<float>(x), std::endian::little);
      }
    }
    file += "\1\2";
  }
  check_square("a.stl", file);
}

TEST_CASE("VRML: order of fields, clockwise, several shapes") {
  const std::string coord = "coord DEF C Coordinate { point [0 0 0, 2 0 0, 2 2 0, 0 2 .5] }";
  const std::string head = "#VRML V2.0 utf8\n";
  check_square("a.wrl", head + "Shape { geometry IndexedFaceSet { " + coord +
                            "\n coordIndex [0,1,2,3,-1] } }");
  check_square("a.wrl",
               head +
                   "WorldInfo { title \"} IndexedFaceSet {\" }\n"
                   "Transform { translation 0 0 0 children [ Shape {\n"
                   "appearance Appearance { textureTransform TextureTransform { scale 2 2 } }\n"
                   "geometry DEF G IndexedFaceSet { coordIndex [0 2 1 -1 0 3 2] ccw FALSE\n"
                   "color Color { color [1 0 0] } colorIndex [0 0 -1] " +
                   coord + " } } ] }");
  const TriangleMesh two =
      mesh_from("a.wrl", head + "Shape { geometry IndexedFaceSet { " + coord +
                             " coordIndex [0 1 2 -1] } } Shape { geometry IndexedFaceSet { " +
                             coord + " coordIndex [0 1 2 -1] } }")
          .mesh;
  CHECK(two.points.size() == 8);
  CHECK(two.triangles == testing::Triangles{{0, 1, 2}, {4, 5, 6}});
}

}  // namespace
}  // namespace tetsculpt
