#include "tests/support/sculpt_rules.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <vector>

namespace tetsculpt::testing {
namespace {

bool has(const Corners& triangle, VertexId v) {
  return std::ranges::find(triangle, v) != triangle.end();
}

bool has(const Corners& triangle, EndPoints edge) {
  return has(triangle, edge.first) && has(triangle, edge.second);
}

/// The edge of a tetrahedron's corners that are not in both, or those that are.
EndPoints edge_where(const std::array<VertexId, 4>& tet, const Corners& f, const Corners& g,
                     bool common) {
  std::vector<VertexId> ends;
  for (const VertexId v : tet) {
    if ((has(f, v) && has(g, v)) == common) ends.push_back(v);
  }
  return std::minmax(ends.at(0), ends.at(1));
}

}  // namespace

Rules::Rules(const Stages& stages) : stages_(&stages), replay_(stages.complex) {
  const TetComplex& complex = stages.complex;
  for (std::uint32_t t = 0; t < complex.triangle_count(); ++t) {
    Corners corners = complex.vertices(TriangleId{t});
    std::sort(corners.begin(), corners.end());
    if (stages.constraints.egh_triangles[t]) egh_.insert(corners);
  }
  for (std::uint32_t e = 0; e < complex.edge_count(); ++e) {
    const auto& [a, b] = complex.vertices(EdgeId{e});
    if (stages.constraints.emst_edges[e]) tree_.insert({a, b});
  }
}

void Rules::remove(TetId t) {
  replay_.remove(t);
  removed_.insert(t);
}

bool Rules::removable(TetId t) const {
  const auto& corners = stages_->complex.vertices(t);
  const std::vector<Corners> faces = replay_.boundary_facets(t);
  if (faces.size() == 1) {
    const auto opposite =
        std::ranges::find_if(corners, [&](VertexId v) { return !has(faces[0], v); });
    return !replay_.on_boundary(*opposite);
  }
  return faces.size() == 2 && !replay_.on_boundary(edge_where(corners, faces[0], faces[1], false));
}

bool Rules::allowed(TetId t) const {
  const std::vector<Corners> faces = replay_.boundary_facets(t);
  return removable(t) && !common_edge_in_tree(t) &&
         std::ranges::none_of(faces, [&](const Corners& f) { return egh_.contains(f); });
}

bool Rules::common_edge_in_tree(TetId t) const {
  const std::vector<Corners> faces = replay_.boundary_facets(t);
  return faces.size() == 2 &&
         in_tree(edge_where(stages_->complex.vertices(t), faces[0], faces[1], true));
}

bool Rules::exposes_tree_edge(TetId t) const {
  const std::vector<Corners> faces = replay_.boundary_facets(t);
  for (const Corners& facet : facets_of(stages_->complex.vertices(t))) {
    for (const EndPoints& edge : edges_of(facet)) {
      const bool stays =
          std::ranges::none_of(faces, [&](const Corners& f) { return has(f, edge); });
      if (stays && in_tree(edge) && !replay_.on_boundary(edge)) return true;
    }
  }
  return false;
}

bool Rules::none(const std::function<bool(TetId)>& property) const {
  return std::ranges::none_of(stages_->tets(), [&](TetId t) { return solid(t) && property(t); });
}

bool Rules::none(bool (Rules::*property)(TetId) const) const {
  return none([this, property](TetId t) { return (this->*property)(t); });
}

}  // namespace tetsculpt::testing
