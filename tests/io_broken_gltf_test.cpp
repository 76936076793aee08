// Broken glTF files are refused with the place of the fault and what it is.
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "tests/support/io_gltf_bytes.h"
#include "tests/support/io_meshes.h"

namespace tetsculpt {
namespace {

using testing::glb_chunk;
using testing::glb_of;
using testing::little;
using testing::mesh_refusal;
using testing::tetrahedron_glb;

/// The text of the tetrahedron with its buffer in it, once `from` has become `to`.
std::string refusal(std::string_view from, std::string_view to) {
  std::string json = testing::tetrahedron_json(
      testing::kTetrahedronMesh,
      "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/"
      "AAIBAAEDAQIDAgAD");
  const std::size_t at = json.find(from);
  REQUIRE(at != std::string::npos);
  return mesh_refusal("a.gltf", json.replace(at, from.size(), to));
}

std::string refusal_of_nodes(const std::string& members) {
  const std::string message = mesh_refusal("a.glb", tetrahedron_glb(members));
  return message.substr(message.find(": ") + 2);
}

TEST_CASE("the container") {
  CHECK(mesh_refusal("a.glb", "glTF") == "byte 4: the file ends in its head");
  std::string file = tetrahedron_glb();
  CHECK(mesh_refusal("a.glb", file) == "read");
  CHECK(mesh_refusal("a.glb", file.substr(0, file.size() - 1)) ==
        "byte 8: " + std::to_string(file.size()) + " bytes announced, the file has " +
            std::to_string(file.size() - 1));
  file[4] = 1;
  CHECK(mesh_refusal("a.glb", file) == "byte 4: version 1 of glTF; 2 is read");
  CHECK(mesh_refusal("a.glb", glb_of(glb_chunk("NOPE", "{}  "))) ==
        "byte 16: the first chunk is not JSON");
  CHECK(mesh_refusal("a.glb", glb_of(little({std::uint32_t{9}}) + "JSON{}  ")) ==
        "byte 12: a chunk that ends behind the end of the file");
  CHECK(mesh_refusal("a.glb", glb_of(glb_chunk("JSON", "{]  "))) ==
        "byte 21: expected the name of a member");
  CHECK(mesh_refusal("a.gltf", "{\n\n]") == "3: expected the name of a member");
  CHECK(mesh_refusal("a.gltf", "ply\n") == "1: expected a value");
}

TEST_CASE("the asset") {
  CHECK(refusal("", "") == "read");
  CHECK(mesh_refusal("a.gltf", "{}") == "1: not a glTF file: no asset");
  CHECK(refusal("2.0", "1.0") == "1: version '1.0' of glTF; 2 is read");
  CHECK(refusal(R"("2.0")", "2") == "1: version must be a text");
  CHECK(refusal(R"("asset")", R"("extensionsRequired":["KHR_draco_mesh_compression"],"asset")") ==
        "1: the file requires the extension 'KHR_draco_mesh_compression', which is not read");
  CHECK(refusal(R"("asset")", R"("extensionsRequired":["KHR_materials_unlit"],"asset")") == "read");
}

TEST_CASE("buffers") {
  CHECK(refusal("data:", "http:") ==
        "1: buffer: 'http:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAA...' is not a file");
  CHECK(refusal("data:;base64,", "").starts_with("1: buffer: there is no file 'AAAAAAAA"));
  CHECK(refusal("AAIB", "A*IB") == "1: buffer: its uri holds no base64 text");
  CHECK(refusal("AAIB", "A") == "1: buffer: its uri holds no base64 text");
  CHECK(refusal(";base64", "") == "1: buffer: its uri holds no base64 text");
  CHECK(refusal(R"("uri")", R"("url")") == "1: buffer: no uri, and no binary chunk");
  CHECK(refusal(":60", ":61") == "1: buffer: 61 bytes announced, there are 60");
  CHECK(refusal(":48}", ":61}") == "1: bufferView: 61 bytes from byte 0 of a buffer of 60");
  CHECK(refusal(R"({"buffer":0)", R"({"buffer":7)") ==
        "1: index 7 into buffers, of which there are 1");
}

TEST_CASE("accessors") {
  CHECK(refusal(R"("count":4)", R"("count":5)") ==
        "1: accessor: 5 elements from byte 0 of a bufferView of 48 bytes");
  CHECK(refusal(R"("count":4)", R"("count":9007199254740991)") ==
        "1: accessor: 9007199254740991 elements from byte 0 of a bufferView of 48 bytes");
  CHECK(refusal(R"("count":4)", R"("count":-1)") == "1: expected a whole number, not negative");
  CHECK(refusal(R"("count":4)", R"("count":0)") == "1: accessor: count is 0");
  CHECK(refusal(R"("count":4)", R"("sparse":{},"count":4)") ==
        "1: accessor: sparse data is not read");
  CHECK(refusal(R"({"bufferView":0,)", "{") ==
        "1: accessor: no bufferView; compressed data is not read");
  CHECK(refusal("5126", "5124") == "1: accessor: unknown componentType 5124");
  CHECK(refusal("VEC3", "MAT4") == "1: accessor: type 'MAT4' is not read");
  CHECK(refusal("VEC3", "VEC2") == "1: positions must be three 32-bit floats each");
  CHECK(refusal("5121", "5120") == "1: indices must be unsigned integers, one each");
  CHECK(refusal(R"("count":12)", R"("count":11)") ==
        "1: 11 corners of triangles, no multiple of three");
  CHECK(refusal(":48}", R"(:48,"byteStride":8})") == "1: accessor: elements of 12 bytes, 8 apart");
}

TEST_CASE("meshes and nodes") {
  CHECK(refusal("AAIBAAED", "AAIBAAEE") == "1: a face names vertex 4 of 4");
  CHECK(refusal(R"("POSITION")", R"("NORMAL")") == "1: no POSITION");
  CHECK(refusal(R"("indices":1)", R"("mode":5)") == "1: strips and fans are not read");
  CHECK(refusal(R"("indices":1)", R"("mode":7)") == "1: unknown mode 7");
  CHECK(refusal_of_nodes(R"("nodes":[{"mesh":3}])") == "index 3 into meshes, of which there are 1");
  CHECK(refusal_of_nodes(R"("nodes":[{}],"scenes":[{"nodes":[2]}])") ==
        "index 2 into nodes, of which there are 1");
  CHECK(refusal_of_nodes(R"("nodes":[{"children":[0]}],"scenes":[{"nodes":[0]}])") ==
        "node 0 is there twice in its scene");
  CHECK(refusal_of_nodes(R"("nodes":[{"matrix":[1,2]}])") == "matrix has 2 numbers, not 16");
  CHECK(refusal_of_nodes(R"("nodes":[{"matrix":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1]}])") ==
        "a matrix whose last row is not 0 0 0 1");
  CHECK(refusal_of_nodes(R"("nodes":[{"rotation":[0,0,0,0]}])") == "a rotation of zeros");
  CHECK(refusal_of_nodes(R"("nodes":[{"scale":[1,"2",3]}])") == "scale needs numbers");
}

}  // namespace
}  // namespace tetsculpt
