// The written files, byte for byte.
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "io/io_error.h"
#include "io/write_mesh.h"
#include "tests/support/io_files.h"
#include "tests/support/io_ply_bytes.h"

namespace tetsculpt {
namespace {

using testing::bytes_of;
using testing::TempDir;

const TriangleMesh kTriangle = {{{0.5, -0.0, 1e22}, {1, 0, 0}, {-0.1, 0, 3}}, {{0, 1, 2}}};

template <typename Number>
std::string little(Number value) {
  return testing::bytes(value, std::endian::little);
}

std::string written(const TriangleMesh& mesh, const std::string& name,
                    Precision precision = Precision::kDouble) {
  const TempDir dir;
  write_mesh(mesh, dir.path() / name, {.precision = precision});
  return bytes_of(dir.path() / name);
}

TEST_CASE("obj") {
  CHECK(written(kTriangle, "a.obj") ==
        "# made by tetsculpt\nv 0.5 -0 1e+22\nv 1 0 0\nv -0.1 0 3\nf 1 2 3\n");
}

TEST_CASE("off") {
  CHECK(written(kTriangle, "a.off") ==
        "OFF\n# made by tetsculpt\n3 1 0\n0.5 -0 1e+22\n1 0 0\n-0.1 0 3\n3 0 1 2\n");
}

TEST_CASE("vrml") {
  const std::string text = written(kTriangle, "a.wrl");
  CHECK(text.starts_with("#VRML V2.0 utf8\n"));
  const std::string tail = text.substr(text.find("  geometry"));
  CHECK(tail ==
        "  geometry IndexedFaceSet {\n    ccw TRUE\n    solid TRUE\n"
        "    coord Coordinate {\n      point [\n0.5 -0 1e+22\n1 0 0\n-0.1 0 3\n      ]\n    }\n"
        "    coordIndex [\n0 1 2 -1\n    ]\n  }\n}\n");
}

std::string ply_head(const std::string& type) {
  std::string text =
      "ply\nformat binary_little_endian 1.0\ncomment made by tetsculpt\nelement vertex 3\n";
  for (const char* axis : {" x\n", " y\n", " z\n"}) text.append("property ").append(type + axis);
  return text + "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
}

TEST_CASE("ply") {
  const std::string face = little(std::uint8_t{3}) + little(0) + little(1) + little(2);
  std::string expected = ply_head("double");
  for (const Point3& p : kTriangle.points) expected += little(p.x) + little(p.y) + little(p.z);
  CHECK(written(kTriangle, "a.ply") == expected + face);

  const TriangleMesh floats = {{{0.5, -0.0, 1}, {1, 0, 0}, {double{0.1F}, 0, 3}}, {{0, 1, 2}}};
  expected = ply_head("float");
  for (const Point3& p : floats.points) {
    for (const double value : {p.x, p.y, p.z}) expected += little(static_cast<float>(value));
  }
  CHECK(written(floats, "a.ply", Precision::kSingle) == expected + face);
}

TEST_CASE("stl") {
  const TriangleMesh mesh = {{{0, 0, 0}, {2, 0, 0}, {0, 0.1, 0}, {4, 0, 0}},
                             {{0, 1, 2}, {0, 2, 1}, {0, 1, 3}}};
  const std::string file = written(mesh, "a.stl");
  REQUIRE(file.size() == 84 + 3 * 50);
  CHECK_FALSE(file.starts_with("solid"));
  CHECK(file.substr(80, 4) == little(std::uint32_t{3}));
  const auto row = [](std::vector<float> values) {
    std::string text;
    for (const float value : values) text += little(value);
    return text + little(std::uint16_t{0});
  };
  CHECK(file.substr(84, 50) == row({0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 0.1F, 0}));
  CHECK(file.substr(134, 50) == row({0, 0, -1, 0, 0, 0, 0, 0.1F, 0, 2, 0, 0}));
  CHECK(file.substr(184, 50) == row({0, 0, 0, 0, 0, 0, 2, 0, 0, 4, 0, 0}));  // no area
}

TEST_CASE("stl: normals of tiny and huge triangles, and what is too large") {
  const auto normal_z = [](double size) {
    const TriangleMesh mesh = {{{0, 0, 0}, {size, 0, 0}, {0, size, 0}}, {{0, 1, 2}}};
    return written(mesh, "a.stl").substr(84 + 8, 4);
  };
  CHECK(normal_z(1e-300) == little(1.0F));
  CHECK(normal_z(std::numeric_limits<double>::denorm_min()) == little(1.0F));
  CHECK(normal_z(std::numeric_limits<float>::max()) == little(1.0F));
  CHECK_THROWS_AS(normal_z(1e39), IoError);
}

TEST_CASE("stl: the normal does not depend on the length of an edge") {
  const auto normal = [](double length) {
    const TriangleMesh mesh = {{{0, 0, 0}, {length, 0, 0}, {0, 1, 0.3}}, {{0, 1, 2}}};
    return written(mesh, "a.stl").substr(84, 12);
  };
  CHECK(normal(1) == normal(1e30));
  CHECK(normal(1) == normal(std::numeric_limits<double>::denorm_min()));
}

TEST_CASE("an empty mesh") {
  CHECK(written({}, "a.obj") == "# made by tetsculpt\n");
  CHECK(written({}, "a.stl").size() == 84);
}

}  // namespace
}  // namespace tetsculpt
