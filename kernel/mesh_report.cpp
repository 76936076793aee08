// The half-edges, sorted so that those of an edge are neighbours, show what each edge has. Corners
// are joined where two triangles at a vertex share an edge that has no third: a vertex is torn if
// its corners stay in several sets, and each open set is a fan that joins two boundary edges.
#include "kernel/mesh_report.h"

#include <algorithm>
#include <span>

#include "kernel/disjoint_sets.h"

namespace tetsculpt {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

bool degenerate(const std::array<std::uint32_t, 3>& c) {
  return c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
}

/// One side of an edge, as a triangle runs along it.
struct HalfEdge {
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t apex;  ///< the triangle's third corner
  std::uint32_t triangle;
  bool ascending;
};

std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh) {
  std::vector<HalfEdge> halves;
  halves.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& c = mesh.triangles[t];
    if (degenerate(c)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = c[i];
      const std::uint32_t b = c[(i + 1) % 3];
      halves.push_back({std::min(a, b), std::max(a, b), c[(i + 2) % 3], t, a < b});
    }
  }
  std::sort(halves.begin(), halves.end(), [](const HalfEdge& p, const HalfEdge& q) {
    if (p.low != q.low) return p.low < q.low;
    if (p.high != q.high) return p.high < q.high;
    if (p.apex != q.apex) return p.apex < q.apex;
    return p.triangle < q.triangle;
  });
  return halves;
}

class Judge {
 public:
  explicit Judge(const TriangleMesh& mesh)
      : mesh_(mesh), fans_(3 * mesh.triangles.size()), torn_(mesh.points.size(), 0) {}

  MeshReport run() && {
    find_shells();
    const std::vector<HalfEdge> halves = sorted_half_edges(mesh_);
    for (std::size_t first = 0; first < halves.size();) {
      std::size_t last = first + 1;
      while (last < halves.size() && halves[last].low == halves[first].low &&
             halves[last].high == halves[first].high) {
        ++last;
      }
      judge_edge({halves.data() + first, last - first});
      first = last;
    }
    count_vertices();
    count_loops();
    return std::move(report_);
  }

 private:
  // The item of the corner of a triangle at a vertex.
  std::size_t corner(std::uint32_t triangle, std::uint32_t vertex) const {
    const auto& c = mesh_.triangles[triangle];
    return 3 * std::size_t{triangle} + (c[0] == vertex ? 0u : c[1] == vertex ? 1u : 2u);
  }

  Shell& shell_of(std::uint32_t vertex) { return report_.shells[report_.shell_of_point[vertex]]; }

  // Also counts their triangles.
  void find_shells() {
    DisjointSets parts(mesh_.points.size());
    report_.shell_of_point.assign(mesh_.points.size(), MeshReport::kNoShell);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto& c = mesh_.triangles[t];
      if (degenerate(c)) {
        report_.degenerate.add(t);
        continue;
      }
      for (const std::uint32_t v : c) {
        parts.unite(c[0], v);
        report_.shell_of_point[v] = 0;  // for now: used
      }
    }
    for (std::uint32_t v = 0; v < mesh_.points.size(); ++v) {
      if (report_.shell_of_point[v] == MeshReport::kNoShell) {
        report_.unused_points.add(v);
        continue;
      }
      const std::uint32_t root = parts.find(v);  // the lowest vertex
      if (root == v) report_.shells.emplace_back();
      report_.shell_of_point[v] = root == v ? static_cast<std::uint32_t>(report_.shells.size() - 1)
                                            : report_.shell_of_point[root];
      ++shell_of(v).vertices;
      ++report_.vertices;
    }
    for (const auto& c : mesh_.triangles) {
      if (!degenerate(c)) ++shell_of(c[0]).triangles;
    }
    report_.triangles = mesh_.triangles.size() - report_.degenerate.count;
  }

  void judge_edge(std::span<const HalfEdge> halves) {
    const HalfEdge& e = halves.front();
    const MeshReport::Edge edge{e.low, e.high};
    Shell& shell = shell_of(e.low);
    ++report_.edges;
    ++shell.edges;
    const auto ascending =
        static_cast<std::size_t>(std::ranges::count_if(halves, &HalfEdge::ascending));
    if (ascending > 1 || halves.size() - ascending > 1) {
      report_.misdirected_edges.add(edge);
      shell.oriented = false;
    }
    if (halves.size() == 1) {
      report_.open_edges.add(edge);
      open_.push_back(e);
    } else if (halves.size() == 2) {
      for (const std::uint32_t v : edge) {
        fans_.unite(corner(e.triangle, v), corner(halves[1].triangle, v));
      }
    } else {
      report_.crowded_edges.add(edge);
      for (const std::uint32_t v : edge) torn_[v] = 1;
    }
    // A repeated triangle is seen at the edge of its two lowest corners alone.
    for (std::size_t i = 1; i < halves.size(); ++i) {
      if (halves[i].apex == halves[i - 1].apex && e.high < halves[i].apex) {
        report_.duplicates.add(halves[i].triangle);
      }
    }
  }

  void count_vertices() {
    std::vector<std::uint32_t> fan_of_vertex(mesh_.points.size(), kNone);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (degenerate(mesh_.triangles[t])) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t v = mesh_.triangles[t][i];
        const std::uint32_t fan = fans_.find(3 * std::size_t{t} + i);
        if (fan_of_vertex[v] == kNone) fan_of_vertex[v] = fan;
        if (fan_of_vertex[v] != fan) torn_[v] = 1;
      }
    }
    for (std::uint32_t v = 0; v < torn_.size(); ++v) {
      if (torn_[v] == 0) continue;
      report_.torn_vertices.add(v);
      shell_of(v).manifold = false;
    }
  }

  void count_loops() {
    DisjointSets chains(open_.size());
    std::vector<std::uint32_t> edge_of_fan(3 * mesh_.triangles.size(), kNone);
    for (std::uint32_t i = 0; i < open_.size(); ++i) {
      for (const std::uint32_t v : {open_[i].low, open_[i].high}) {
        std::uint32_t& other = edge_of_fan[fans_.find(corner(open_[i].triangle, v))];
        if (other == kNone) {
          other = i;
        } else {
          chains.unite(i, other);
        }
      }
    }
    for (std::uint32_t i = 0; i < open_.size(); ++i) {
      if (chains.find(i) != i) continue;
      ++report_.boundary_loops;
      ++shell_of(open_[i].low).boundary_loops;
    }
  }

  const TriangleMesh& mesh_;
  DisjointSets fans_;  // of corners
  std::vector<std::uint8_t> torn_;
  std::vector<HalfEdge> open_;
  MeshReport report_;
};

}  // namespace

std::optional<std::size_t> Shell::genus() const {
  if (!manifold || !oriented) return std::nullopt;
  return (2 + edges - vertices - triangles - boundary_loops) / 2;
}

MeshReport judge(const TriangleMesh& mesh) { return Judge(mesh).run(); }

}  // namespace tetsculpt
