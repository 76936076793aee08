// turn() visits every triangle at an edge exactly once, in cyclic order, from the edge's own
// triangle.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "kernel/delaunay.h"
#include "kernel/distinct_points.h"
#include "tests/support/graph_oracles.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

using oracle::Edge;
using oracle::Tet;

/// From the list of tetrahedra alone, infinite ones included.
struct Incidence {
  std::set<Tet> tets;
  std::map<Edge, std::set<VertexId>> links;
};

Incidence incidence(const TetComplex& complex) {
  Incidence result;
  for (std::uint32_t t = 0; t < complex.tet_count(); ++t) {
    Tet v = complex.vertices(TetId{t});
    std::sort(v.begin(), v.end());
    result.tets.insert(v);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        for (std::size_t k = 0; k < 4; ++k) {
          if (k != i && k != j) result.links[{v[i], v[j]}].insert(v[k]);
        }
      }
    }
  }
  return result;
}

bool adjacent(const Incidence& all, const Edge& e, VertexId p, VertexId q) {
  Tet tet{e[0], e[1], p, q};
  std::sort(tet.begin(), tet.end());
  return all.tets.contains(tet);
}

/// The facet handed to the visitor is the triangle of the edge and `third`.
bool right_facet(const TetComplex& complex, const Facet& f, const Edge& e, VertexId third) {
  Tet corners = complex.vertices(f.tet);
  corners[static_cast<std::size_t>(f.corner)] = e[0];  // now {e0, e0, e1, third}
  Tet expected{e[0], e[0], e[1], third};
  std::sort(corners.begin(), corners.end());
  std::sort(expected.begin(), expected.end());
  return corners == expected;
}

std::size_t bad_turns(const TetComplex& complex) {
  const Incidence all = incidence(complex);
  std::size_t bad = 0;
  for (std::uint32_t i = 0; i < complex.edge_count(); ++i) {
    const EdgeId id{i};
    const Edge e = complex.vertices(id);
    std::vector<VertexId> thirds;
    complex.turn(id, [&](Facet f, VertexId third) {
      bad += !right_facet(complex, f, e, third);
      if (thirds.empty()) bad += complex.triangle(f.tet, f.corner) != complex.triangle(id);
      thirds.push_back(third);
      return true;
    });
    for (std::size_t k = 0; k < thirds.size(); ++k) {
      bad += !adjacent(all, e, thirds[k], thirds[(k + 1) % thirds.size()]);
    }
    const std::set<VertexId> once(thirds.begin(), thirds.end());
    bad += once.size() != thirds.size() || once != all.links.at(e);
  }
  return bad;
}

TEST_CASE("small and middling solids") {
  for (const auto& sets : {oracle::small_solids(), oracle::middling_solids()}) {
    for (const auto& set : sets) {
      CAPTURE(set.name);
      const TetComplex complex = delaunay(distinct_points(set.points));
      CHECK(complex.edge_count() > 0);
      CHECK(bad_turns(complex) == 0);
    }
  }
}

TEST_CASE("turning stops when told to") {
  const TetComplex complex = delaunay(distinct_points(point_sets::uniform_cube(100, 1)));
  std::size_t wrong = 0;
  for (std::uint32_t e = 0; e < complex.edge_count(); ++e) {
    int visits = 0;
    complex.turn(EdgeId{e}, [&](Facet, VertexId) { return ++visits < 2; });
    wrong += visits != 2;
  }
  CHECK(wrong == 0);
}

}  // namespace
}  // namespace tetsculpt
