#include "tests/support/sculpt_replay.h"

#include <algorithm>
#include <cstdint>

#include "kernel/disjoint_sets.h"

namespace tetsculpt::testing {
namespace {

/// Is a graph, given by its edges, one cycle?
bool one_cycle(const std::vector<EndPoints>& edges) {
  std::map<VertexId, std::vector<VertexId>> neighbors;
  for (const auto& [a, b] : edges) {
    neighbors[a].push_back(b);
    neighbors[b].push_back(a);
  }
  for (const auto& [vertex, ends] : neighbors) {
    if (ends.size() != 2) return false;
  }
  const VertexId start = edges.front().first;
  VertexId before = start;
  VertexId here = neighbors[start].front();
  std::size_t length = 1;
  for (; here != start; ++length) {
    const auto& ends = neighbors[here];
    before = std::exchange(here, ends[0] == before ? ends[1] : ends[0]);
  }
  return length == edges.size();
}

}  // namespace

std::array<Corners, 4> facets_of(const std::array<VertexId, 4>& tet) {
  std::array<VertexId, 4> v = tet;
  std::sort(v.begin(), v.end());
  return {{{v[1], v[2], v[3]}, {v[0], v[2], v[3]}, {v[0], v[1], v[3]}, {v[0], v[1], v[2]}}};
}

std::array<EndPoints, 3> edges_of(const Corners& t) {
  return {{{t[0], t[1]}, {t[0], t[2]}, {t[1], t[2]}}};
}

Replay::Replay(const TetComplex& complex) : complex_(&complex) {
  // A facet of two tetrahedra is toggled twice.
  for (std::uint32_t t = 0; t < complex.finite_tet_count(); ++t) remove(TetId{t});
}

void Replay::remove(TetId t) {
  for (const Corners& facet : facets_of(complex_->vertices(t))) toggle(facet);
}

void Replay::toggle(const Corners& triangle) {
  const bool joins = triangles_.insert(triangle).second;
  if (!joins) triangles_.erase(triangle);
  for (const EndPoints& edge : edges_of(triangle)) {
    int& count = triangles_at_edge_[edge];
    count += joins ? 1 : -1;
    if (count == 0) triangles_at_edge_.erase(edge);
  }
  for (const VertexId v : triangle) {
    auto& star = triangles_at_vertex_[v];
    if (joins) {
      star.insert(triangle);
    } else {
      star.erase(triangle);
    }
    if (star.empty()) triangles_at_vertex_.erase(v);
  }
}

std::vector<Corners> Replay::boundary_facets(TetId t) const {
  std::vector<Corners> found;
  for (const Corners& facet : facets_of(complex_->vertices(t))) {
    if (on_boundary(facet)) found.push_back(facet);
  }
  return found;
}

long Replay::euler_number() const {
  return static_cast<long>(triangles_at_vertex_.size()) -
         static_cast<long>(triangles_at_edge_.size()) + static_cast<long>(triangles_.size());
}

std::size_t Replay::components() const {
  DisjointSets sets(complex_->vertex_count());
  std::size_t count = triangles_at_vertex_.size();
  for (const Corners& t : triangles_) {
    count -= sets.unite(+t[0], +t[1]);
    count -= sets.unite(+t[1], +t[2]);
  }
  return count;
}

std::optional<std::string> Replay::not_manifold_at(std::span<const VertexId> vertices) const {
  for (const VertexId v : vertices) {
    const auto star = triangles_at_vertex_.find(v);
    if (star == triangles_at_vertex_.end()) continue;
    std::vector<EndPoints> link;
    for (const Corners& t : star->second) {
      for (const auto& [a, b] : edges_of(t)) {
        if (a != v && b != v) link.emplace_back(a, b);
        if ((a == v || b == v) && triangles_at_edge_.at({a, b}) != 2) {
          return "edge " + std::to_string(+a) + " " + std::to_string(+b) + " has " +
                 std::to_string(triangles_at_edge_.at({a, b})) + " triangles";
        }
      }
    }
    if (!one_cycle(link)) return "the link of vertex " + std::to_string(+v) + " is no cycle";
  }
  return std::nullopt;
}

std::optional<std::string> Replay::not_manifold() const {
  std::vector<VertexId> all;
  for (const auto& [v, star] : triangles_at_vertex_) all.push_back(v);
  return not_manifold_at(all);
}

std::vector<RemovalStep> removal_steps(const Sculpture& sculpture) {
  std::vector<RemovalStep> steps;
  const std::span<const TetId> removed = sculpture.removed;
  for (std::size_t i = 0; i < removed.size();) {
    const bool hole = std::binary_search(sculpture.holes.begin(), sculpture.holes.end(), i);
    steps.push_back({removed.subspan(i, hole ? 3 : 1), hole});
    i += hole ? 3 : 1;
  }
  return steps;
}

}  // namespace tetsculpt::testing
