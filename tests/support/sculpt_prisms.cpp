#include "tests/support/sculpt_prisms.h"

#include <algorithm>
#include <cstdint>
#include <map>

namespace tetsculpt::testing {
namespace {

Corners triangle(VertexId a, VertexId b, VertexId c) {
  Corners corners{a, b, c};
  std::sort(corners.begin(), corners.end());
  return corners;
}

EndPoints segment(VertexId a, VertexId b) { return std::minmax(a, b); }

std::set<VertexId> corners(const Stages& s, TetId t) {
  const auto& v = s.complex.vertices(t);
  return {v.begin(), v.end()};
}

/// The corners of t that are not corners of u.
std::vector<VertexId> only_in(const Stages& s, TetId t, TetId u) {
  const std::set<VertexId> other = corners(s, u);
  std::vector<VertexId> rest;
  for (const VertexId v : corners(s, t)) {
    if (!other.contains(v)) rest.push_back(v);
  }
  return rest;
}

/// The definition, for one way to name the two vertices that all three tetrahedra share.
bool is_prism(const Rules& rules, VertexId a, VertexId b, VertexId c, VertexId d, VertexId e,
              VertexId f, const std::set<EndPoints>& flagged) {
  const Replay& r = rules.replay();
  if (!r.on_boundary(triangle(a, b, c)) || !r.on_boundary(triangle(d, e, f))) return false;
  for (const Corners& coastal : {triangle(a, b, d), triangle(a, c, d), triangle(b, d, e),
                                 triangle(b, c, e), triangle(c, d, f), triangle(c, e, f)}) {
    if (r.on_boundary(coastal)) return false;
  }
  bool any_flagged = false;
  for (const EndPoints& coastal :
       {segment(a, d), segment(b, d), segment(c, d), segment(b, e), segment(c, e), segment(c, f)}) {
    if (r.on_boundary(coastal)) return false;
    any_flagged = any_flagged || flagged.contains(coastal);
  }
  return any_flagged;
}

}  // namespace

std::vector<Chain> all_chains(const Stages& s, const Rules& rules) {
  std::map<Corners, std::vector<TetId>> at_facet;
  for (const TetId t : s.tets()) {
    if (!rules.solid(t)) continue;
    for (const Corners& f : facets_of(s.complex.vertices(t))) at_facet[f].push_back(t);
  }
  std::map<TetId, std::set<TetId>> neighbors;
  for (const auto& [facet, tets] : at_facet) {
    if (tets.size() < 2) continue;
    neighbors[tets[0]].insert(tets[1]);
    neighbors[tets[1]].insert(tets[0]);
  }
  std::vector<Chain> chains;
  for (const auto& [middle, around] : neighbors) {
    for (const TetId first : around) {
      for (const TetId last : around) {
        if (first != last) chains.push_back({first, middle, last});
      }
    }
  }
  return chains;
}

bool is_prism(const Stages& s, const Rules& rules, const Chain& chain,
              const std::set<EndPoints>& flagged) {
  std::set<VertexId> all;
  for (const TetId t : chain) all.merge(corners(s, t));
  if (all.size() != 6) return false;
  const auto [first, middle, last] = chain;
  const VertexId a = only_in(s, first, middle).at(0);
  const VertexId b = only_in(s, middle, last).at(0);
  const VertexId e = only_in(s, middle, first).at(0);
  const VertexId f = only_in(s, last, middle).at(0);
  for (const VertexId v : {a, b, e, f}) all.erase(v);
  const VertexId c = *all.begin();
  const VertexId d = *all.rbegin();
  return is_prism(rules, a, b, c, d, e, f, flagged) || is_prism(rules, a, b, d, c, e, f, flagged);
}

std::set<EndPoints> end_points(const Stages& s, const Flags& flagged) {
  std::set<EndPoints> edges;
  for (std::uint32_t e = 0; e < flagged.size(); ++e) {
    const auto& [a, b] = s.complex.vertices(EdgeId{e});
    if (flagged[e]) edges.insert(segment(a, b));
  }
  return edges;
}

}  // namespace tetsculpt::testing
