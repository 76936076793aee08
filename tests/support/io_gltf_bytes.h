#pragma once

#include <bit>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "tests/support/io_ply_bytes.h"

/// Building glTF files by hand.
namespace tetsculpt::testing {

template <typename Number>
std::string little(std::initializer_list<Number> values) {
  std::string all;
  for (const Number value : values) all += bytes(value, std::endian::little);
  return all;
}

inline std::string glb_chunk(std::string_view kind, std::string_view content) {
  return little({static_cast<std::uint32_t>(content.size())}).append(kind).append(content);
}

/// A .glb file with these chunks.
inline std::string glb_of(std::string_view chunks) {
  return std::string("glTF")
      .append(little({std::uint32_t{2}, static_cast<std::uint32_t>(12 + chunks.size())}))
      .append(chunks);
}

inline std::string glb(std::string json, std::string binary) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4, '\0');
  return glb_of(glb_chunk("JSON", json) + glb_chunk(std::string_view("BIN", 4), binary));
}

/// The four points of a tetrahedron, 48 bytes, and the corners of its four triangles, 12 bytes.
inline const std::string kTetrahedronPoints =
    little({0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F});
inline const std::string kTetrahedronCorners =
    little<std::uint8_t>({0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3});

/// The JSON text of an asset with `members`, and buffers and accessors (0: points, 1: corners) for
/// these 60 bytes; the buffer has the member `uri` if that is not empty.
inline std::string tetrahedron_json(std::string_view members, std::string_view uri = "") {
  return std::string(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":60)")
      .append(uri.empty() ? "" : R"(,"uri":")")
      .append(uri)
      .append(uri.empty() ? "" : "\"")
      .append(R"(}],"bufferViews":[{"buffer":0,"byteLength":48},)")
      .append(R"({"buffer":0,"byteOffset":48,"byteLength":12}],"accessors":[)")
      .append(R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)")
      .append(R"({"bufferView":1,"componentType":5121,"count":12,"type":"SCALAR"}],)")
      .append(members)
      .append("}");
}

inline constexpr std::string_view kTetrahedronMesh =
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}])";

/// A .glb file of the tetrahedron with these members besides its mesh.
inline std::string tetrahedron_glb(std::string_view members = "") {
  return glb(tetrahedron_json(
                 std::string(kTetrahedronMesh).append(members.empty() ? "" : ",").append(members)),
             kTetrahedronPoints + kTetrahedronCorners);
}

}  // namespace tetsculpt::testing
