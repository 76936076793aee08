// glTF assets, read back by a reader of their own.
#include "tests/support/io_gltf.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "io/io_error.h"
#include "io/write_mesh.h"
#include "tests/support/io_files.h"
#include "tests/support/io_hard_points.h"

namespace tetsculpt {
namespace {

using testing::elements_of;
using testing::Gltf;
using testing::GltfNumbers;
using testing::Json;
using testing::TempDir;

struct Written {
  Gltf asset;
  WriteReport report;
};

Written written(const TriangleMesh& mesh, const std::string& name,
                const std::vector<Attribute>& attributes = {}) {
  const TempDir dir;
  const auto path = dir.path() / name;
  const WriteReport report = write_mesh(mesh, path, {.attributes = attributes});
  const std::string file = testing::bytes_of(path);
  return {name.ends_with("glb") ? testing::gltf_of_binary(file) : testing::gltf_of_text(file),
          report};
}

const Json& primitive(const Gltf& asset) {
  const std::size_t node = asset.json["scenes"][asset.json["scene"].size()]["nodes"][0].size();
  const std::size_t mesh = asset.json["nodes"][node]["mesh"].size();
  return asset.json["meshes"][mesh]["primitives"][0];
}

GltfNumbers attribute(const Gltf& asset, const std::string& semantic) {
  return elements_of(asset, primitive(asset)["attributes"][semantic].size());
}

Point3 translation(const Gltf& asset) {
  const Json& node = asset.json["nodes"][0];
  if (!node.has("translation")) return {};
  const Json& t = node["translation"];
  return {t[0].number(), t[1].number(), t[2].number()};
}

std::vector<Point3> positions(const Gltf& asset) {
  const Point3 t = translation(asset);
  std::vector<Point3> points;
  for (const auto& p : attribute(asset, "POSITION").elements) {
    points.push_back({t.x + p[0], t.y + p[1], t.z + p[2]});
  }
  return points;
}

const TriangleMesh kTetrahedron = {{{0, 0, 0}, {1.5, 0, 0}, {0, -2, 0}, {0, 0, 0.25}},
                                   {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};

TEST_CASE("points, triangles, bounds, in both containers") {
  for (const char* name : {"a.gltf", "a.glb"}) {
    CAPTURE(name);
    const auto [asset, report] = written(kTetrahedron, name);
    CHECK(report == WriteReport{});
    CHECK(asset.json["asset"]["version"].text == "2.0");
    CHECK(positions(asset) == kTetrahedron.points);
    const Json& accessor =
        asset.json["accessors"][primitive(asset)["attributes"]["POSITION"].size()];
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(accessor["min"][k].number() == std::vector<double>{0, -2, 0}[k]);
      CHECK(accessor["max"][k].number() == std::vector<double>{1.5, 0, 0.25}[k]);
    }
    const GltfNumbers indices = elements_of(asset, primitive(asset)["indices"].size());
    CHECK(indices.type == 5125);
    REQUIRE(indices.elements.size() == 12);
    for (std::size_t i = 0; i < 12; ++i) {
      CHECK(indices.elements[i][0] == kTetrahedron.triangles[i / 3][i % 3]);
    }
    CHECK_FALSE(primitive(asset).has("mode"));
  }
}

TEST_CASE("coordinates that are floats stay, however far they are") {
  auto points = testing::points_of(testing::hard_numbers<float>());
  points.resize(points.size() / 3 * 3);
  const Written all = written({points, {{0, 1, 2}}}, "a.glb");
  CHECK(all.report == WriteReport{});
  CHECK(translation(all.asset) == Point3{});
  const auto back = attribute(all.asset, "POSITION").elements;
  std::vector<Point3> read;
  for (const auto& p : back) read.push_back({p[0], p[1], p[2]});
  CHECK(testing::same_bits(read, points));
}

TEST_CASE("large coordinates keep the digits of their differences") {
  TriangleMesh mesh = kTetrahedron;
  for (Point3& p : mesh.points) p = {p.x + 3'500'000.125, p.y + 5'800'000.0625, p.z + 0.3};
  const auto [asset, report] = written(mesh, "a.gltf");
  CHECK(report.rounded == std::vector<std::string>{"z"});
  const std::vector<Point3> back = positions(asset);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(back[i].x == mesh.points[i].x);
    CHECK(back[i].y == mesh.points[i].y);
    CHECK(std::abs(back[i].z - mesh.points[i].z) < 1e-7);
  }
}

TEST_CASE("colours, normals and other attributes") {
  const std::vector<Attribute> attributes = {
      {"red", std::vector<std::uint8_t>{0, 1, 2, 255}},
      {"green", std::vector<std::uint8_t>{3, 4, 5, 6}},
      {"blue", std::vector<std::uint8_t>{7, 8, 9, 10}},
      {"nx", std::vector<float>{1, 0, 0, 0.6F}},
      {"ny", std::vector<float>{0, 1, 0, 0.8F}},
      {"nz", std::vector<float>{0, 0, -1, 0}},
      {"class", std::vector<std::int8_t>{-128, 127, 0, 1}},
      {"count", std::vector<std::uint32_t>{0, 1, 1U << 24, (1U << 24) + 1}},
      {"say \"\\", std::vector<std::int16_t>{1, 2, 3, 4}},
      {"\"\\", std::vector<std::int16_t>{-32768, 2, 3, 4}},
      {"time", std::vector<double>{1e300, 0, 0, 0}},
      {"dip", std::vector<double>{0.1, 0, 0, 0}},
      {"dip", std::vector<double>{0.5, 0, 0, 0}},
      {"gap", std::vector<float>{NAN, 0, 0, 0}}};
  for (const char* name : {"a.gltf", "a.glb"}) {
    const auto [asset, report] = written(kTetrahedron, name, attributes);
    CHECK(report.rounded == std::vector<std::string>{"count", "dip"});
    CHECK(report.dropped == std::vector<std::string>{"say \"\\", "dip", "time", "gap"});
    const GltfNumbers colours = attribute(asset, "COLOR_0");
    CHECK(colours.type == 5121);
    CHECK(colours.normalized);
    CHECK(colours.elements[3] == std::vector<double>{255, 6, 10});
    CHECK(attribute(asset, "NORMAL").elements[2] == std::vector<double>{0, 0, -1});
    CHECK(attribute(asset, "_class").type == 5120);
    CHECK(attribute(asset, "_class").elements[0][0] == -128);
    CHECK_FALSE(attribute(asset, "_class").normalized);
    CHECK(attribute(asset, "_count").elements[3][0] == 1U << 24);
    CHECK(attribute(asset, "_\"\\").elements[0][0] == -32768);
    CHECK(attribute(asset, "_dip").elements[0][0] == double{0.1F});
    CHECK(primitive(asset)["attributes"].members.size() == 7);
  }
}

TEST_CASE("alpha, wide colours, normals that are none") {
  const std::vector<std::uint16_t> wide = {0, 1, 40000, 65535};
  const Written colours = written(
      kTetrahedron, "a.glb", {{"alpha", wide}, {"red", wide}, {"green", wide}, {"blue", wide}});
  CHECK(colours.report == WriteReport{});
  CHECK(attribute(colours.asset, "COLOR_0").type == 5123);
  CHECK(attribute(colours.asset, "COLOR_0").elements[2] ==
        std::vector<double>{40000, 40000, 40000, 40000});
  const std::vector<float> zero = {0, 1, 0, 0};
  const Written normals =
      written(kTetrahedron, "a.glb", {{"nx", zero}, {"ny", zero}, {"nz", zero}});
  CHECK(normals.report == WriteReport{});
  CHECK_FALSE(primitive(normals.asset)["attributes"].has("NORMAL"));
  CHECK(attribute(normals.asset, "_nz").elements[1][0] == 1);
}

TEST_CASE("no triangles, no points, too large ones, and more than one piece") {
  const Written dots = written({kTetrahedron.points, {}}, "a.gltf");
  CHECK(primitive(dots.asset)["mode"].number() == 0);
  CHECK_FALSE(primitive(dots.asset).has("indices"));
  CHECK_FALSE(written({}, "a.gltf").asset.json.has("meshes"));
  CHECK_FALSE(written({}, "a.glb").asset.json.has("meshes"));
  CHECK_THROWS_AS(written({{{-1e39, 0, 0}, {1e39, 0, 0}}, {}}, "a.glb"), IoError);
  TriangleMesh large;
  for (std::uint32_t i = 0; i < 10'001; ++i) {
    large.points.push_back({double{1} * i, double{1} * (i % 7), 1});
    if (i >= 2) large.triangles.push_back({i, i - 1, i - 2});
  }
  for (const char* name : {"a.gltf", "a.glb"}) {
    const Gltf asset = written(large, name).asset;
    CHECK(positions(asset) == large.points);
    CHECK(elements_of(asset, primitive(asset)["indices"].size()).elements.back()[0] == 9998);
  }
}

}  // namespace
}  // namespace tetsculpt
