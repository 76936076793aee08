#include "kernel/triangle_mesh.h"

#include <algorithm>

#include "kernel/disjoint_sets.h"

namespace tetsculpt {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// One side of an edge, as a triangle runs along it.
struct HalfEdge {
  std::uint32_t low;
  std::uint32_t high;
  bool ascending;
  std::uint32_t triangle;
};

std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh) {
  std::vector<HalfEdge> halves;
  halves.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = mesh.triangles[t][i];
      const std::uint32_t b = mesh.triangles[t][(i + 1) % 3];
      halves.push_back({std::min(a, b), std::max(a, b), a < b, t});
    }
  }
  std::sort(halves.begin(), halves.end(), [](const HalfEdge& p, const HalfEdge& q) {
    if (p.low != q.low) return p.low < q.low;
    if (p.high != q.high) return p.high < q.high;
    return p.triangle < q.triangle;
  });
  return halves;
}

/// Corner i of triangle t as an item of 3 n.
std::size_t corner_item(const TriangleMesh& mesh, std::uint32_t t, std::uint32_t vertex) {
  const Triangle& c = mesh.triangles[t];
  return 3 * std::size_t{t} + (c[0] == vertex ? 0u : c[1] == vertex ? 1u : 2u);
}

/// What sorting the half-edges shows.
struct EdgeSurvey {
  std::size_t edges = 0;
  bool closed = true;
  bool manifold = true;
  bool oriented = true;
  DisjointSets fans;  ///< corners, joined where two triangles at a vertex share an edge
  explicit EdgeSurvey(std::size_t corners) : fans(corners) {}
};

EdgeSurvey survey_edges(const TriangleMesh& mesh) {
  EdgeSurvey survey(3 * mesh.triangles.size());
  const std::vector<HalfEdge> halves = sorted_half_edges(mesh);
  for (std::size_t first = 0; first < halves.size();) {
    std::size_t last = first;
    std::size_t ascending = 0;
    const HalfEdge& e = halves[first];
    for (; last < halves.size() && halves[last].low == e.low && halves[last].high == e.high;
         ++last) {
      ascending += halves[last].ascending;
    }
    const std::size_t count = last - first;
    for (const std::uint32_t v : {e.low, e.high}) {
      if (count != 2) break;
      survey.fans.unite(corner_item(mesh, e.triangle, v),
                        corner_item(mesh, halves[first + 1].triangle, v));
    }
    ++survey.edges;
    survey.closed = survey.closed && count == 2;
    survey.manifold = survey.manifold && count <= 2;
    survey.oriented = survey.oriented && ascending <= 1 && count - ascending <= 1;
    first = last;
  }
  return survey;
}

}  // namespace

Topology topology(const TriangleMesh& mesh) {
  EdgeSurvey survey = survey_edges(mesh);
  Topology result{.closed = survey.closed && !mesh.triangles.empty(),
                  .edge_manifold = survey.manifold,
                  .vertex_manifold = survey.manifold,
                  .oriented = survey.oriented};
  DisjointSets parts(mesh.points.size());
  std::vector<std::uint32_t> fan_of_vertex(mesh.points.size(), 0xffffffffu);
  std::size_t vertices = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = mesh.triangles[t][i];
      parts.unite(mesh.triangles[t][0], v);
      const std::uint32_t fan = survey.fans.find(3 * std::size_t{t} + i);
      if (fan_of_vertex[v] == 0xffffffffu) {
        fan_of_vertex[v] = fan;
        ++vertices;
      } else if (fan_of_vertex[v] != fan) {
        result.vertex_manifold = false;
      }
    }
  }
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    if (fan_of_vertex[v] != 0xffffffffu && parts.find(v) == v) ++result.components;
  }
  if (result.closed && result.vertex_manifold && result.oriented) {
    // V - E + F = 2 (components - genus)
    const auto euler = static_cast<std::int64_t>(vertices + mesh.triangles.size()) -
                       static_cast<std::int64_t>(survey.edges);
    result.genus = result.components - static_cast<std::size_t>(euler / 2);
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
