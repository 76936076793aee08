// Legacy VTK files, read back by a reader of their own.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "io/write_mesh.h"
#include "tests/support/io_all_attributes.h"
#include "tests/support/io_files.h"
#include "tests/support/io_hard_points.h"
#include "tests/support/io_vtk.h"

namespace tetsculpt {
namespace {

using testing::TempDir;
using testing::VtkFile;

std::string written(const TriangleMesh& mesh, const WriteMeshOptions& options = {},
                    const WriteReport& expected = {}) {
  const TempDir dir;
  CHECK(write_mesh(mesh, dir.path() / "a.vtk", options) == expected);
  return testing::bytes_of(dir.path() / "a.vtk");
}

TEST_CASE("coordinates bit for bit, triangles") {
  const auto points = testing::points_of(testing::hard_numbers<double>());
  const std::string bytes = written({points, {{0, 1, 2}, {3, 2, 1}}});
  const VtkFile file(bytes);
  CHECK(file.data_set == "DATASET POLYDATA");
  CHECK(file.point_type == "double");
  CHECK(testing::same_bits(file.points, points));
  CHECK(file.cells == std::vector<std::vector<std::int32_t>>{{0, 1, 2}, {3, 2, 1}});
  CHECK(file.attributes_of.empty());
}

TEST_CASE("floats stay floats") {
  const auto points = testing::points_of(testing::hard_numbers<float>());
  const std::string bytes = written({points, {}}, {.precision = Precision::kSingle});
  const VtkFile file(bytes);
  CHECK(file.point_type == "float");
  CHECK(testing::same_bits(file.points, points));
  CHECK(file.cells.empty());
}

TEST_CASE("attributes of every type, by name") {
  const std::vector<Attribute> attributes = testing::attributes_of_every_type();
  const TriangleMesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const std::string bytes = written(mesh, {.attributes = attributes});
  const VtkFile file(bytes);
  CHECK(file.attributes_of == "POINT_DATA 3");
  CHECK(file.attributes == attributes);
}

TEST_CASE("names that the format can't hold are reported") {
  const std::vector<float> one = {1};
  const std::vector<Attribute> attributes = {{"x", one},   {"two words", one},   {"", one},
                                             {"x", {one}}, {"caf\xc3\xa9", one}, {"line\n", one}};
  const std::string bytes =
      written({{{0, 0, 0}}, {}}, {.attributes = attributes},
              {.rounded = {}, .dropped = {"two words", "", "x", "caf\xc3\xa9", "line\n"}});
  CHECK(VtkFile(bytes).attributes == std::vector<Attribute>{attributes[0]});
}

TEST_CASE("more than one piece") {
  TriangleMesh mesh{std::vector<Point3>(10'000), {}};
  std::vector<std::int16_t> numbers;
  for (std::uint32_t i = 0; i < 10'000; ++i) {
    mesh.points[i].x = i;
    numbers.push_back(static_cast<std::int16_t>(i));
    mesh.triangles.push_back({i, i / 2, i / 3});
  }
  const std::vector<Attribute> attributes = {{"number", numbers}};
  const std::string bytes = written(mesh, {.attributes = attributes});
  const VtkFile file(bytes);
  CHECK(testing::same_bits(file.points, mesh.points));
  CHECK(file.attributes == attributes);
  CHECK(file.cells.at(9'999) == std::vector<std::int32_t>{9'999, 4'999, 3'333});
}

}  // namespace
}  // namespace tetsculpt
