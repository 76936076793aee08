// Broken mesh files are refused with the place of the fault: above all, corners that are no vertex.
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <string>

#include "tests/support/io_meshes.h"
#include "tests/support/io_ply_bytes.h"

namespace tetsculpt {
namespace {

using testing::bytes;
using testing::mesh_refusal;

const std::string kTwoCorners = "a face needs at least 3 corners, this one has 2";

TEST_CASE("ply") {
  const std::string vertices =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
  const auto refusal = [&](const std::string& elements, const std::string& rows) {
    return mesh_refusal("a.ply", testing::ply_header("ascii", vertices + elements) +
                                     "0 0 0\n1 0 0\n0 1 0\n" + rows);
  };
  CHECK(refusal(faces, "3 0 1 2\n") == "read");
  CHECK(refusal(faces, "3 0 1 3\n") == "13: a face names vertex 3 of 3");
  CHECK(refusal(faces, "3 0 -1 2\n") == "13: a face names vertex -1 of 3");
  CHECK(refusal(faces, "3 0 1.5 2\n") == "13: a face names vertex 1.5 of 3");
  CHECK(refusal(faces, "3 0 nan 2\n") == "13: a face names vertex nan of 3");
  CHECK(refusal(faces, "2 0 1\n") == "13: " + kTwoCorners);
  CHECK(refusal(faces, "3 0 1\n") == "13: expected a number, found the end of the line");
  CHECK(refusal(faces, "3 0 1 2 2\n") == "13: the line has more values than the header says");
  CHECK(refusal(faces, "") == "12: the file ends after 0 of 1 elements face");
  CHECK(refusal("", "") == "7: the header has no element face with a list vertex_indices");
  CHECK(refusal("element tristrips 1\nproperty list int int vertex_indices\n", "3 0 1 2\n") ==
        "9: triangle strips are not read");
}

TEST_CASE("ply, binary") {
  const std::string header =
      testing::ply_header("binary_little_endian",
                          "element vertex 1\nproperty char x\nproperty char y\nproperty char z\n"
                          "element face 1\nproperty list char short vertex_indices\n");
  const auto refusal = [&](const std::string& body) {
    return mesh_refusal("a.ply", header + std::string(3, '\0') + body);
  };
  const auto place = [&](std::size_t at) { return "byte " + std::to_string(header.size() + at); };
  CHECK(refusal(std::string("\3\0\0\0\0\0\0", 7)) == "read");
  CHECK(refusal(std::string("\3\0\0\1\0\0\0", 7)) == place(6) + ": a face names vertex 1 of 1");
  CHECK(refusal(std::string("\3\0\0\xff\xff\0\0", 7)) ==
        place(6) + ": a face names vertex -1 of 1");
  CHECK(refusal("\xff") == place(3) + ": negative length of a list");
  CHECK(refusal(std::string("\3\0\0\0\0", 5)) ==
        place(4) + ": list items: 3 of at least 2 bytes announced, 4 bytes left");
}

TEST_CASE("obj") {
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  CHECK(mesh_refusal("a.obj", v + "f 1 2 4\nf 1 2 9\nf 1 2 5\n") ==
        "5: a face names vertex 9 of 3");
  CHECK(mesh_refusal("a.obj", v + "f 1 2 0\n") == "4: a face names vertex 0 of 3");
  CHECK(mesh_refusal("a.obj", v + "f 1 2 -4\n") == "4: a face names vertex -4 of 3");
  CHECK(mesh_refusal("a.obj", v + "f 1 2 99999999999999999999\n") ==
        "4: a corner of a face must begin with an index");
  CHECK(mesh_refusal("a.obj", v + "f 1 2 x\n") == "4: a corner of a face must begin with an index");
  CHECK(mesh_refusal("a.obj", v + "f 1 2\n") == "4: " + kTwoCorners);
}

TEST_CASE("off") {
  const std::string head = "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  CHECK(mesh_refusal("a.off", head + "3 0 1 3\n") == "5: a face names vertex 3 of 3");
  CHECK(mesh_refusal("a.off", head + "3 0 1 -1\n") == "5: expected a count, found '-1'");
  CHECK(mesh_refusal("a.off", head + "2 0 1\n") == "5: " + kTwoCorners);
  CHECK(mesh_refusal("a.off", head) == "4: the file ends after 0 of 1 faces");
  CHECK(mesh_refusal("a.off", "OFF 1\n0 0 0\n") == "1: the number of faces is missing");
}

TEST_CASE("stl") {
  const std::string facet = "facet\nouter loop\nvertex 0 0 0\nvertex 0 1 0\n";
  CHECK(mesh_refusal("a.stl", "solid\n" + facet + "endloop\nendfacet\nendsolid\n") ==
        "6: " + kTwoCorners);
  CHECK(mesh_refusal("a.stl", "solid\n" + facet) == "5: the file ends within a loop");
  CHECK(mesh_refusal("a.stl", "solid\n" + facet + "vertex 0 0\n") ==
        "6: expected a number, found the end of the line");
  CHECK(mesh_refusal("a.stl", "solid\n") == "1: the file ends without endsolid");
  CHECK(mesh_refusal("a.stl", "solid\nendsolid\n" + facet) == "3: a facet outside of a solid");
  CHECK(mesh_refusal("a.stl", "solid\nvertex 0 0 0\n") == "2: expected facet or endsolid");
  CHECK(mesh_refusal("a.stl", "x") == "not an STL file: too short");
  const std::string binary = std::string(80, ' ') + bytes(std::uint32_t{2}, std::endian::little);
  CHECK(mesh_refusal("a.stl", binary + std::string(99, '\0')) ==
        "byte 80: 2 triangles of 50 bytes announced, 99 bytes behind it");
  CHECK(mesh_refusal("a.stl", binary + std::string(100, '\0')) == "read");
}

TEST_CASE("vrml") {
  const auto refusal = [](const std::string& text) {
    return mesh_refusal("a.wrl", "#VRML V2.0 utf8\n" + text);
  };
  const std::string coord = "coord Coordinate { point [ 0 0 0, 1 0 0, 0 1 0 ] }\n";
  const auto faces = [&](const std::string& index) {
    return "Shape { geometry IndexedFaceSet { " + coord + "coordIndex [ " + index + " ] } }";
  };
  CHECK(refusal(faces("0 1 2 -1")) == "read");
  CHECK(refusal(faces("0 1 3 -1")) == "3: a face names vertex 3 of 3");
  CHECK(refusal(faces("0 1 -2")) == "3: a face names vertex -2 of 3");
  CHECK(refusal(faces("0 1 -1")) == "3: " + kTwoCorners);
  CHECK(refusal(faces("0 1 2.5")) == "3: expected an integer, found '2.5'");
  CHECK(refusal("Shape { geometry IndexedFaceSet { coord USE C } }") ==
        "2: expected a Coordinate node, found 'USE'");
  CHECK(refusal("Transform { translation 1 0 0 children [] }") ==
        "2: a Transform with a translation is not read");
  CHECK(refusal("Transform { rotation 0 0 1 0.5 }") ==
        "2: a Transform with a rotation is not read");
  CHECK(refusal("Transform { scale 1 1 2 }") == "2: a Transform with a scale is not read");
  CHECK(refusal("Shape { geometry Sphere { } }") == "2: Sphere is not read");
  CHECK(refusal("Group { children [ USE S ] }") == "2: instances (USE) are not read");
  CHECK(refusal("Group { }") == "2: the file has no IndexedFaceSet with faces");
  CHECK(refusal("Shape { geometry IndexedFaceSet { ") == "2: the file ends within a node");
  CHECK(refusal("WorldInfo { title \"a") == "2: a quotation without its end");
  CHECK(mesh_refusal("a.wrl", "#VRML V1.0 ascii\n") == "1: not a VRML 2.0 file");
}

}  // namespace
}  // namespace tetsculpt
