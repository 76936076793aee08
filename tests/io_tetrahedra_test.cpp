// Tetrahedra in files have the coordinates bit for bit, positive volumes and their labels.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "io/io_error.h"
#include "io/tetrahedra_writer.h"
#include "kernel/predicates.h"
#include "tests/support/io_files.h"
#include "tests/support/io_hard_points.h"
#include "tests/support/io_vtk.h"

namespace tetsculpt {
namespace {

using testing::TempDir;

const TetMesh kTwo = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}, {0, 0, -0.1}},
                      {{0, 2, 1, 3}, {0, 1, 2, 4}},
                      {1, 0}};

std::string written(const TetMesh& mesh, const std::string& name) {
  const TempDir dir;
  write_tetrahedra(mesh, dir.path() / name);
  return testing::bytes_of(dir.path() / name);
}

TEST_CASE("the corners as given have a positive orient3d") {
  for (const auto& [a, b, c, d] : kTwo.tetrahedra) {
    const auto& p = kTwo.points;
    CHECK(orient3d(p[a], p[b], p[c], p[d]) == Sign::kPositive);
  }
}

TEST_CASE("vtk") {
  const std::string bytes = written(kTwo, "a.vtk");
  const testing::VtkFile file(bytes);
  CHECK(file.data_set == "DATASET UNSTRUCTURED_GRID");
  CHECK(testing::same_bits(file.points, kTwo.points));
  CHECK(file.cell_types == std::vector<std::int32_t>{10, 10});
  CHECK(file.attributes_of == "CELL_DATA 2");
  CHECK(file.attributes == std::vector<Attribute>{{"inside", std::vector<std::uint8_t>{1, 0}}});
  // The fourth corner is on the side from which the others look counterclockwise.
  for (const auto& cell : file.cells) {
    REQUIRE(cell.size() == 4);
    const auto p = [&](std::size_t k) { return file.points.at(static_cast<std::size_t>(cell[k])); };
    CHECK(orient3d(p(0), p(1), p(2), p(3)) == Sign::kNegative);
  }
}

TEST_CASE("medit") {
  CHECK(written(kTwo, "a.MESH") ==
        "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 0.1 0\n"
        "0 0 -0.1 0\nTetrahedra\n2\n1 3 4 2 1\n1 2 5 3 0\nEnd\n");
}

TEST_CASE("hard coordinates") {
  const TetMesh mesh = {testing::points_of(testing::hard_numbers<double>()), {}, {}};
  const std::string bytes = written(mesh, "a.vtk");
  CHECK(testing::same_bits(testing::VtkFile(bytes).points, mesh.points));
}

TEST_CASE("another extension, a full device") {
  const TempDir dir;
  CHECK_FALSE(writable_tetrahedra_extension("a.ply"));
  CHECK_THROWS_AS(write_tetrahedra(kTwo, dir.path() / "a.ply"), IoError);
  CHECK(std::filesystem::is_empty(dir.path()));
  if (!std::filesystem::exists("/dev/full")) return;
  for (const char* name : {"a.vtk", "a.mesh"}) {
    std::filesystem::create_symlink("/dev/full", dir.path() / name);
    CHECK_THROWS_AS(write_tetrahedra(kTwo, dir.path() / name), IoError);
  }
}

}  // namespace
}  // namespace tetsculpt
