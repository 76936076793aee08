// What write_mesh writes, read_mesh reads: the same triangles of the same points.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "tests/support/io_files.h"
#include "tests/support/io_hard_points.h"
#include "tests/support/meshes.h"

namespace tetsculpt {
namespace {

using testing::TempDir;

/// Every point in a triangle, in order, so that STL keeps the order, too.
TriangleMesh hard_mesh(const std::vector<Point3>& points) {
  TriangleMesh mesh{points, {}};
  for (std::uint32_t i = 0; i + 2 < points.size(); ++i) mesh.triangles.push_back({i, i + 1, i + 2});
  return mesh;
}

MeshFile there_and_back(const TriangleMesh& mesh, const std::string& name,
                        const WriteMeshOptions& options = {}) {
  const TempDir dir;
  write_mesh(mesh, dir.path() / name, options);
  return read_mesh(dir.path() / name);
}

TEST_CASE("doubles, bit for bit") {
  const TriangleMesh mesh = hard_mesh(testing::points_of(testing::hard_numbers<double>()));
  for (const std::string name : {"a.ply", "a.OBJ", "a.off", "a.wrl"}) {
    INFO(name);
    const MeshFile file = there_and_back(mesh, name);
    CHECK(testing::same_bits(file.mesh.points, mesh.points));
    CHECK(file.mesh.triangles == mesh.triangles);
    CHECK(file.precision == Precision::kDouble);
  }
}

TEST_CASE("floats, bit for bit") {
  const TriangleMesh mesh = hard_mesh(testing::points_of(testing::hard_numbers<float>()));
  for (const std::string name : {"a.ply", "a.gltf", "a.glb"}) {
    INFO(name);
    const MeshFile file = there_and_back(mesh, name, {.precision = Precision::kSingle});
    CHECK(testing::same_bits(file.mesh.points, mesh.points));
    CHECK(file.mesh.triangles == mesh.triangles);
    CHECK(file.precision == Precision::kSingle);
  }
}

TEST_CASE("STL gives equal corners one vertex") {
  const TriangleMesh mesh = testing::with(testing::cube(-1, 1), testing::cube(0.1F, 0.3F, 7));
  const MeshFile stl = there_and_back(mesh, "a.stl");
  CHECK(stl.precision == Precision::kSingle);
  CHECK(stl.mesh.points.size() == 16);
  REQUIRE(stl.mesh.triangles.size() == mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3& read = stl.mesh.points[stl.mesh.triangles[t][i]];
      const Point3& written = mesh.points[mesh.triangles[t][i]];
      CHECK(static_cast<float>(read.x) == static_cast<float>(written.x));
      CHECK(static_cast<float>(read.z) == static_cast<float>(written.z));
    }
  }
}

TEST_CASE("no triangles") {
  const TriangleMesh none{{{1, 2, 3}}, {}};
  for (const std::string name : {"a.ply", "a.obj", "a.off"}) {
    INFO(name);
    CHECK(there_and_back(none, name).mesh.points == none.points);
  }
  for (const std::string name : {"a.stl", "a.gltf", "a.glb"}) {
    CHECK(there_and_back({}, name).mesh.points.empty());
  }
}

TEST_CASE("an unknown extension is refused with the known ones") {
  try {
    read_mesh("a.xyz");
    FAIL("read");
  } catch (const IoError& error) {
    CHECK(std::string(error.what()).find(mesh_source_extensions()) != std::string::npos);
  }
}

}  // namespace
}  // namespace tetsculpt
