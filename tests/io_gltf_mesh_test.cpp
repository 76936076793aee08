// The meshes of glTF assets are read as the specification says, wherever their bytes are.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "io/base64.h"
#include "io/write_mesh.h"
#include "kernel/mesh_report.h"
#include "tests/support/io_files.h"
#include "tests/support/io_gltf_bytes.h"
#include "tests/support/io_meshes.h"

namespace tetsculpt {
namespace {

using testing::glb;
using testing::kTetrahedronCorners;
using testing::kTetrahedronPoints;
using testing::little;
using testing::mesh_from;
using testing::tetrahedron_glb;
using testing::tetrahedron_json;

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

const std::vector<Point3> kPoints = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const Triangles kTriangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

void check_tetrahedron(const MeshFile& file) {
  CHECK(file.mesh.points == kPoints);
  CHECK(file.mesh.triangles == kTriangles);
  CHECK(file.precision == Precision::kSingle);
}

TEST_CASE("buffers: the binary chunk, base64, and a file") {
  check_tetrahedron(mesh_from("a.glb", tetrahedron_glb()));
  check_tetrahedron(mesh_from("a.gltf", tetrahedron_glb()));  // the content counts
  const std::string bytes = kTetrahedronPoints + kTetrahedronCorners;
  const std::string mesh(testing::kTetrahedronMesh);
  for (const std::string type : {"application/octet-stream", "application/gltf-buffer", ""}) {
    check_tetrahedron(
        mesh_from("a.gltf", tetrahedron_json(mesh, "data:" + type + ";base64," + base64(bytes))));
  }
  const testing::TempDir dir;
  dir.file("my buffer.bin", bytes);
  check_tetrahedron(read_mesh(dir.file("a.gltf", tetrahedron_json(mesh, "my%20buffer.bin"))));
}

TEST_CASE("indices of every type, and strides") {
  const auto file = [](const std::string& type, const std::string& corners) {
    return glb(
        R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":200}],"bufferViews":[)"
        R"({"buffer":0,"byteLength":64,"byteStride":16},)"
        R"({"buffer":0,"byteOffset":64,"byteLength":)" +
            std::to_string(corners.size()) +
            R"(}],"accessors":[{"bufferView":0,"byteOffset":4,"componentType":5126,)"
            R"("count":4,"type":"VEC3"},{"bufferView":1,"componentType":)" +
            type + R"(,"count":12,"type":"SCALAR"}],)" + std::string(testing::kTetrahedronMesh) +
            "}",
        little({9.F, 0.F, 0.F, 0.F, 9.F, 1.F, 0.F, 0.F, 9.F, 0.F, 1.F, 0.F, 9.F, 0.F, 0.F, 1.F}) +
            corners + std::string(200, '\0'));
  };
  check_tetrahedron(mesh_from("a.glb", file("5121", kTetrahedronCorners)));
  check_tetrahedron(mesh_from(
      "a.glb", file("5123", little<std::uint16_t>({0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}))));
  check_tetrahedron(mesh_from(
      "a.glb", file("5125", little<std::uint32_t>({0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}))));
}

TEST_CASE("without indices, corners of one position are one vertex") {
  std::string corners;
  for (const char corner : kTetrahedronCorners) {
    corners += kTetrahedronPoints.substr(static_cast<std::size_t>(corner) * 12, 12);
  }
  const MeshFile file = mesh_from(
      "a.glb",
      glb(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":144}],"bufferViews":[)"
          R"({"buffer":0,"byteLength":144}],"accessors":[{"bufferView":0,"componentType":5126,)"
          R"("count":12,"type":"VEC3"}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]})",
          corners));
  CHECK(file.mesh.points == std::vector<Point3>{kPoints[0], kPoints[2], kPoints[1], kPoints[3]});
  CHECK(judge(file.mesh).closed());
}

TEST_CASE("nodes move, turn and mirror") {
  const auto moved = [](const std::string& nodes) {
    return mesh_from("a.glb",
                     tetrahedron_glb(R"("scene":0,"scenes":[{"nodes":[0]}],"nodes":)" + nodes));
  };
  const MeshFile shifted = moved(R"([{"mesh":0,"translation":[0.1,2,0]}])");
  CHECK(shifted.mesh.points[1] == Point3{1.1, 2, 0});
  CHECK(shifted.precision == Precision::kDouble);
  CHECK(moved(R"([{"mesh":0,"scale":[2,3,4]}])").mesh.points[3] == Point3{0, 0, 4});
  const MeshFile turned = moved(R"([{"children":[1],"translation":[5,0,0]},)"
                                R"({"mesh":0,"rotation":[0,0,1,0]}])");
  CHECK(turned.mesh.points[1] == Point3{4, 0, 0});
  CHECK(turned.mesh.triangles == kTriangles);
  const MeshFile mirrored = moved(R"([{"mesh":0,"matrix":[-1,0,0,0, 0,1,0,0, 0,0,1,0, 7,0,0,1]}])");
  CHECK(mirrored.mesh.points[1] == Point3{6, 0, 0});
  CHECK(mirrored.mesh.triangles.front() == std::array<std::uint32_t, 3>{0, 1, 2});
  check_tetrahedron(moved(R"([{"mesh":0,"skin":0,"translation":[1,0,0]}])"));
}

TEST_CASE("all nodes of the scene, and only they") {
  const std::string nodes = R"("nodes":[{"mesh":0},{"mesh":0,"translation":[3,0,0]},{"mesh":0}])";
  const auto points = [&](const std::string& members) {
    return mesh_from("a.glb", tetrahedron_glb(members + nodes)).mesh.points;
  };
  CHECK(points(R"("scenes":[{"nodes":[1]},{"nodes":[0,2]}],)").front() == Point3{3, 0, 0});
  CHECK(points(R"("scene":1,"scenes":[{"nodes":[1]},{"nodes":[2,0]}],)").size() == 8);
  CHECK(points("").size() == 12);
  CHECK(points(R"("scenes":[{}],)").empty());
}

TEST_CASE("primitives of one accessor share vertices, others do not") {
  const auto shells = [](const std::string& second) {
    const std::string bytes = kTetrahedronPoints + kTetrahedronCorners;
    const std::string json =
        R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":60}],"bufferViews":[)"
        R"({"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12}],)"
        R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
        R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
        R"({"bufferView":1,"componentType":5121,"count":6,"type":"SCALAR"},)"
        R"({"bufferView":1,"byteOffset":6,"componentType":5121,"count":6,"type":"SCALAR"}],)"
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":2},)"
        R"({"attributes":{"POSITION":)" +
        second + R"(},"indices":3},{"attributes":{"POSITION":0},"mode":0}]}]})";
    const MeshFile file = mesh_from("a.glb", glb(json, bytes));
    CHECK(file.mesh.triangles.size() == 4);
    return judge(file.mesh).shells.size();
  };
  CHECK(shells("0") == 1);
  CHECK(shells("1") == 2);
}

TEST_CASE("what was moved to keep its digits comes back") {
  TriangleMesh mesh{kPoints, kTriangles};
  for (Point3& p : mesh.points) p = {p.x + 3'500'000.125, p.y + 5'800'000.0625, p.z};
  for (const char* name : {"a.gltf", "a.glb"}) {
    const testing::TempDir dir;
    CHECK(write_mesh(mesh, dir.path() / name) == WriteReport{});
    const MeshFile back = read_mesh(dir.path() / name);
    CHECK(back.mesh.points == mesh.points);
    CHECK(back.mesh.triangles == mesh.triangles);
  }
}

}  // namespace
}  // namespace tetsculpt
