// "glTF 2.0 Specification" (Khronos Group 2021), sections 3.5 (scenes) and 3.7 (meshes).
#include "io/gltf_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/byte_order.h"
#include "io/gltf_buffers.h"
#include "io/gltf_codes.h"
#include "io/gltf_json.h"
#include "io/gltf_transform.h"
#include "io/polygon_fan.h"
#include "kernel/welded.h"

namespace tetsculpt {
namespace {

constexpr std::uint64_t kFirstOfTriangles = 4;  // modes below are of points and lines
constexpr std::uint64_t kLastOfTriangles = 6;

template <typename Number>
Number load(const char* from) {
  return load_number<Number>(from, std::endian::little);
}

std::uint32_t index_at(const GltfElements& indices, std::size_t i) {
  const char* const from = indices.first + i * indices.stride;
  if (indices.type == GltfType::kUint8) return load<std::uint8_t>(from);
  if (indices.type == GltfType::kUint16) return load<std::uint16_t>(from);
  return load<std::uint32_t>(from);
}

class GltfMeshes {
 public:
  explicit GltfMeshes(const GltfJson& json)
      : json_(json), buffers_(json), visited_(json.list(json.root(), "nodes").size(), false) {}

  MeshFile join() && {
    const JsonValue& root = json_.root();
    if (!visited_.empty()) {
      add_nodes(roots());
    } else {
      for (const JsonValue& mesh : json_.list(root, "meshes")) add_mesh(mesh, {});
    }
    if (!moved_) file_.precision = Precision::kSingle;
    return std::move(file_);
  }

 private:
  /// A node that is still to be added, and what its parents do to it.
  struct Pending {
    std::size_t node;
    GltfTransform above;
  };

  std::vector<std::size_t> roots() const {
    const std::span<const JsonValue> scenes = json_.list(json_.root(), "scenes");
    if (scenes.empty()) return nodes_without_parent();
    const std::uint64_t scene = json_.integer_if_any(json_.root(), "scene").value_or(0);
    return nodes_of(json_.item("scenes", scene, json_.root()), "nodes");
  }

  std::vector<std::size_t> nodes_of(const JsonValue& object, std::string_view name) const {
    std::vector<std::size_t> nodes;
    for (const JsonValue& index : json_.list(object, name)) {
      nodes.push_back(static_cast<std::size_t>(json_.integer(index)));
      json_.item("nodes", nodes.back(), index);
    }
    return nodes;
  }

  std::vector<std::size_t> nodes_without_parent() const {
    std::vector<bool> has_parent(visited_.size(), false);
    for (const JsonValue& node : json_.list(json_.root(), "nodes")) {
      for (const std::size_t child : nodes_of(node, "children")) has_parent[child] = true;
    }
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < has_parent.size(); ++i) {
      if (!has_parent[i]) nodes.push_back(i);
    }
    return nodes;
  }

  // Depth first, in the order of the lists.
  void add_nodes(const std::vector<std::size_t>& roots) {
    std::vector<Pending> stack;
    const auto push = [&stack](const std::vector<std::size_t>& nodes, const GltfTransform& above) {
      for (std::size_t i = nodes.size(); i-- > 0;) stack.push_back({nodes[i], above});
    };
    push(roots, {});
    while (!stack.empty()) {
      const Pending next = stack.back();
      stack.pop_back();
      const JsonValue& node = json_.item("nodes", next.node, json_.root());
      if (visited_[next.node]) {
        json_.fail(node, "node " + std::to_string(next.node) + " is there twice in its scene");
      }
      visited_[next.node] = true;
      const GltfTransform transform = composed(next.above, gltf_transform(json_, node));
      if (const auto mesh = json_.integer_if_any(node, "mesh")) {
        const bool has_skin = node.member("skin") != nullptr;  // then the node does not move it
        add_mesh(json_.item("meshes", *mesh, node), has_skin ? GltfTransform() : transform);
      }
      push(nodes_of(node, "children"), transform);
    }
  }

  void add_mesh(const JsonValue& mesh, const GltfTransform& transform) {
    bases_.clear();
    moved_ = moved_ || transform != GltfTransform();
    for (const JsonValue& primitive : json_.list(mesh, "primitives")) {
      const std::uint64_t mode =
          json_.integer_if_any(primitive, "mode").value_or(kFirstOfTriangles);
      if (mode > kLastOfTriangles) json_.fail(primitive, "unknown mode " + std::to_string(mode));
      if (mode > kFirstOfTriangles) json_.fail(primitive, "strips and fans are not read");
      if (mode == kFirstOfTriangles) add_triangles(primitive, transform);
    }
  }

  void add_triangles(const JsonValue& primitive, const GltfTransform& transform) {
    const JsonValue* const attributes = primitive.member("attributes");
    if (attributes == nullptr) json_.fail(primitive, "no attributes");
    const std::uint64_t accessor = json_.integer(*attributes, "POSITION");
    const GltfElements positions =
        buffers_.elements(json_.item("accessors", accessor, *attributes));
    if (positions.type != GltfType::kFloat32 || positions.components != 3) {
      json_.fail(*attributes, "positions must be three 32-bit floats each");
    }
    const auto indices = json_.integer_if_any(primitive, "indices");
    const std::size_t first = file_.mesh.triangles.size();
    if (indices) {
      const auto known = bases_.find(accessor);
      const std::uint32_t base = known != bases_.end()
                                     ? known->second
                                     : append(points_of(positions, transform), primitive);
      bases_[accessor] = base;
      add_corners(json_.item("accessors", *indices, primitive), positions.count, base);
    } else {
      add_soup(points_of(positions, transform), primitive);
    }
    if (!transform.mirrors()) return;
    for (std::size_t t = first; t < file_.mesh.triangles.size(); ++t) {
      std::swap(file_.mesh.triangles[t][1], file_.mesh.triangles[t][2]);
    }
  }

  static std::vector<Point3> points_of(const GltfElements& positions,
                                       const GltfTransform& transform) {
    std::vector<Point3> points;
    points.reserve(positions.count);
    for (std::size_t i = 0; i < positions.count; ++i) {
      const char* const from = positions.first + i * positions.stride;
      const auto value = [from](std::size_t k) { return double{load<float>(from + 4 * k)}; };
      points.push_back(transform({value(0), value(1), value(2)}));
    }
    return points;
  }

  /// The number of the first of them.
  std::uint32_t append(const std::vector<Point3>& points, const JsonValue& primitive) {
    const std::size_t base = file_.mesh.points.size();
    if (points.size() > UINT32_MAX - base) {
      json_.fail(primitive, "more points than 32-bit indices can tell apart");
    }
    file_.mesh.points.insert(file_.mesh.points.end(), points.begin(), points.end());
    return static_cast<std::uint32_t>(base);
  }

  void add_corners(const JsonValue& accessor, std::size_t vertices, std::uint32_t base) {
    const GltfElements indices = buffers_.elements(accessor);
    if (indices.components != 1 ||
        (indices.type != GltfType::kUint8 && indices.type != GltfType::kUint16 &&
         indices.type != GltfType::kUint32)) {
      json_.fail(accessor, "indices must be unsigned integers, one each");
    }
    check_thirds(indices.count, accessor);
    for (std::size_t i = 0; i < indices.count; i += 3) {
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t index = index_at(indices, i + k);
        if (index >= vertices) {
          json_.fail(accessor, no_such_vertex(std::to_string(index), vertices));
        }
        corners[k] = base + index;
      }
      file_.mesh.triangles.push_back(corners);
    }
  }

  void add_soup(std::vector<Point3> corners, const JsonValue& primitive) {
    check_thirds(corners.size(), primitive);
    TriangleMesh soup{std::move(corners), {}};
    for (std::uint32_t v = 0; v + 2 < soup.points.size(); v += 3) {
      soup.triangles.push_back({v, v + 1, v + 2});
    }
    soup = welded(std::move(soup));
    const std::uint32_t base = append(soup.points, primitive);
    for (const auto& [a, b, c] : soup.triangles) {
      file_.mesh.triangles.push_back({base + a, base + b, base + c});
    }
  }

  void check_thirds(std::size_t corners, const JsonValue& from) const {
    if (corners % 3 == 0) return;
    json_.fail(from, std::to_string(corners) + " corners of triangles, no multiple of three");
  }

  const GltfJson& json_;
  GltfBuffers buffers_;
  std::vector<bool> visited_;                     // by node
  std::map<std::uint64_t, std::uint32_t> bases_;  // of the points of an accessor, in this node
  MeshFile file_;
  bool moved_ = false;
};

}  // namespace

MeshFile parse_gltf_mesh(std::string_view content, const std::filesystem::path& path) {
  const GltfJson json(content, path);
  return GltfMeshes(json).join();
}

}  // namespace tetsculpt
