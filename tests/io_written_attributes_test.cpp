// Attributes in the written files, byte for byte, and what the report says of the others.
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "io/write_mesh.h"
#include "tests/support/io_all_attributes.h"
#include "tests/support/io_files.h"
#include "tests/support/io_ply_bytes.h"

namespace tetsculpt {
namespace {

using testing::colours;
using testing::TempDir;

const TriangleMesh kTriangle = {{{0.5, -0.0, 1e22}, {1, 0, 0}, {-0.1, 0, 3}}, {{0, 1, 2}}};
const std::vector<Attribute> kNormals = {{"nx", std::vector<double>{1, 0, -0.0}},
                                         {"ny", std::vector<double>{0, 0.1, 0}},
                                         {"nz", std::vector<double>{0, 0, -1}}};
const std::vector<std::uint8_t> kBytes = {0, 128, 255};

/// The file, with `expected` in the report as dropped and nothing as rounded.
std::string written(const std::string& name, const std::vector<Attribute>& attributes,
                    const std::vector<std::string>& dropped = {},
                    PlyEncoding encoding = PlyEncoding::kBinary) {
  const TempDir dir;
  const WriteReport report = write_mesh(kTriangle, dir.path() / name,
                                        {.ply_encoding = encoding, .attributes = attributes});
  CHECK(report.dropped == dropped);
  CHECK(report.rounded == std::vector<std::string>{});
  return testing::bytes_of(dir.path() / name);
}

std::vector<Attribute> joined(std::vector<Attribute> a, const std::vector<Attribute>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const std::string kPlyHead =
    "comment made by tetsculpt\nelement vertex 3\nproperty double x\nproperty double y\n"
    "property double z\n";
const std::string kPlyTypes =
    "property char a\nproperty uchar b\nproperty short c\nproperty ushort d\nproperty int e\n"
    "property uint f\nproperty float g\nproperty double h\n";
const std::string kPlyFaces =
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

TEST_CASE("ply: every type, binary") {
  const auto attributes = testing::attributes_of_every_type();
  std::string expected =
      "ply\nformat binary_little_endian 1.0\n" + kPlyHead + kPlyTypes + kPlyFaces;
  const auto add = [&](auto value) { expected += testing::bytes(value, std::endian::little); };
  for (std::size_t i = 0; i < 3; ++i) {
    const Point3& p = kTriangle.points[i];
    for (const double value : {p.x, p.y, p.z}) add(value);
    for (const Attribute& a : attributes) std::visit([&](const auto& v) { add(v[i]); }, a.values);
  }
  add(std::uint8_t{3});
  for (const int corner : {0, 1, 2}) add(corner);
  CHECK(written("a.ply", attributes) == expected);
}

TEST_CASE("ply: every type, ascii") {
  CHECK(written("a.ply", testing::attributes_of_every_type(), {}, PlyEncoding::kAscii) ==
        "ply\nformat ascii 1.0\n" + kPlyHead + kPlyTypes + kPlyFaces +
            "0.5 -0 1e+22 -128 0 -32768 0 -2147483648 0 -3.4028235e+38 "
            "-1.7976931348623157e+308\n"
            "1 0 0 127 255 32767 65535 2147483647 4294967295 3.4028235e+38 "
            "1.7976931348623157e+308\n"
            "-0.1 0 3 -1 200 -2 40000 -3 3000000000 -0 0.1\n3 0 1 2\n");
}

TEST_CASE("ply: names that no property can have") {
  const std::vector<Attribute> attributes = {
      {"z", kBytes}, {"two words", kBytes}, {"q", kBytes}, {"q", kBytes}, {"", kBytes}};
  CHECK(written("a.ply", attributes, {"z", "two words", "q", ""})
            .find("property uchar q\nelement face") != std::string::npos);
}

TEST_CASE("obj") {
  const auto all = joined(colours(kBytes, kBytes, kBytes, kBytes), {{"time", kBytes}});
  CHECK(written("a.obj", all, {"time", "alpha"}) ==
        "# made by tetsculpt\nv 0.5 -0 1e+22 0 0 0\n"
        "v 1 0 0 0.5019608 0.5019608 0.5019608\nv -0.1 0 3 1 1 1\nf 1 2 3\n");
  CHECK(written("a.obj", kNormals) ==
        "# made by tetsculpt\nv 0.5 -0 1e+22\nv 1 0 0\nv -0.1 0 3\nvn 1 0 0\nvn 0 0.1 0\n"
        "vn -0 0 -1\nf 1//1 2//2 3//3\n");
}

TEST_CASE("off") {
  const std::string head = "OFF\n# made by tetsculpt\n3 1 0\n";
  const auto rgb = colours(kBytes, kBytes, {1, 2, 3});
  CHECK(written("a.off", rgb) == "C" + head +
                                     "0.5 -0 1e+22 0 0 1 255\n1 0 0 128 128 2 255\n"
                                     "-0.1 0 3 255 255 3 255\n3 0 1 2\n");
  CHECK(written("a.off", kNormals) ==
        "N" + head + "0.5 -0 1e+22 1 0 0\n1 0 0 0 0.1 0\n-0.1 0 3 -0 0 -1\n3 0 1 2\n");
  const std::vector<double> shares = {0, 0.1, 1e-9};
  CHECK(written("a.off", joined(kNormals, colours(shares, shares, shares, shares))) ==
        "CN" + head +
            "0.5 -0 1e+22 1 0 0 0.0 0.0 0.0 0.0\n1 0 0 0 0.1 0 0.1 0.1 0.1 0.1\n"
            "-0.1 0 3 -0 0 -1 1e-09 1e-09 1e-09 1e-09\n3 0 1 2\n");
  const std::vector<std::uint16_t> wide = {0, 65535, 1};
  CHECK(written("a.off", colours(wide, wide, wide))
            .ends_with("0.5 -0 1e+22 0.0 0.0 0.0 1.0\n1 0 0 1.0 1.0 1.0 1.0\n"
                       "-0.1 0 3 1.5259022e-05 1.5259022e-05 1.5259022e-05 1.0\n3 0 1 2\n"));
}

TEST_CASE("vrml") {
  const std::string text =
      written("a.wrl", joined(kNormals, colours(kBytes, kBytes, kBytes, kBytes)), {"alpha"});
  CHECK(text.find("      ]\n    }\n    color Color {\n      color [\n0 0 0\n"
                  "0.5019608 0.5019608 0.5019608\n1 1 1\n      ]\n    }\n    normal Normal {\n"
                  "      vector [\n1 0 0\n0 0.1 0\n-0 0 -1\n      ]\n    }\n    coordIndex [\n") !=
        std::string::npos);
}

TEST_CASE("what is no colour and no normal") {
  const std::vector<std::int32_t> ints = {0, 1, 2};
  const std::vector<float> holes = {NAN, 1, 2};
  const std::vector<float> floats = {0, 1, 2};
  for (const std::string name : {"a.obj", "a.off", "a.wrl"}) {
    CAPTURE(name);
    const std::string plain = written(name, {});
    CHECK(written(name, colours(ints, ints, ints), {"red", "green", "blue"}) == plain);
    CHECK(written(name, colours(holes, floats, floats), {"red", "green", "blue"}) == plain);
    CHECK(written(name, {{"red", floats}, {"green", kBytes}, {"blue", floats}},
                  {"red", "green", "blue"}) == plain);
    CHECK(written(name, {{"red", kBytes}, {"green", kBytes}}, {"red", "green"}) == plain);
    CHECK(written(name, {{"nx", holes}, {"ny", floats}, {"nz", floats}}, {"nx", "ny", "nz"}) ==
          plain);
    CHECK(written(name, {{"nx", kBytes}, {"ny", kBytes}, {"nz", kBytes}}, {"nx", "ny", "nz"}) ==
          plain);
  }
}

TEST_CASE("stl holds none") {
  const TempDir dir;
  const WriteReport report =
      write_mesh({{{0.1, 1, -0.0}}, {}}, dir.path() / "a.stl",
                 {.attributes = std::vector<Attribute>{{"red", std::vector<std::uint8_t>{1}}}});
  CHECK(report == WriteReport{.rounded = {"x"}, .dropped = {"red"}});
}

}  // namespace
}  // namespace tetsculpt
