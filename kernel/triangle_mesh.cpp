#include "kernel/triangle_mesh.h"

#include <algorithm>

#include "kernel/mesh_report.h"

namespace tetsculpt {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

}  // namespace

Topology topology(const TriangleMesh& mesh) {
  const MeshReport report = judge(mesh);
  Topology result{.closed = report.closed(),
                  .edge_manifold = report.crowded_edges.count == 0,
                  .vertex_manifold = report.torn_vertices.count == 0,
                  .oriented = report.misdirected_edges.count == 0,
                  .components = report.shells.size()};
  if (result.closed && result.vertex_manifold && result.oriented) {
    for (const Shell& shell : report.shells) result.genus += shell.genus().value_or(0);
  }
  return result;
}

std::optional<std::string> broken_invariant(const TriangleMesh& mesh) {
  std::vector<Triangle> sorted = mesh.triangles;
  for (std::size_t t = 0; t < sorted.size(); ++t) {
    Triangle& c = sorted[t];
    const std::string name = "triangle " + std::to_string(t);
    for (const std::uint32_t v : c) {
      if (v >= mesh.points.size()) return name + " names a point that is not there";
    }
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) return name + " is degenerate";
    std::sort(c.begin(), c.end());
  }
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
    return "a triangle occurs twice";
  }
  const Topology t = topology(mesh);
  if (!t.closed) return "an edge does not have exactly two triangles";
  if (!t.oriented) return "two triangles run along an edge in the same direction";
  if (!t.vertex_manifold) return "a vertex has more than one cycle of triangles";
  return std::nullopt;
}

}  // namespace tetsculpt
