#include "sculpt/deform.h"

#include <algorithm>
#include <queue>
#include <vector>

#include "sculpt/exposure.h"
#include "sculpt/priority.h"

namespace tetsculpt {
namespace {

constexpr TetId kNoTet{0xffffffffu};

bool flippable(const Boundary& boundary, TetId t) {
  return boundary.complex().finite(t) && exposure(boundary, t).removable;
}

/// The tetrahedra at a vertex, found by walking through its star.
std::vector<TetId> star_of(const TetComplex& complex, VertexId v) {
  std::vector<TetId> star{complex.tet(v)};
  for (std::size_t k = 0; k < star.size(); ++k) {
    for (int i = 0; i < 4; ++i) {
      if (complex.vertices(star[k])[static_cast<std::size_t>(i)] == v) continue;
      const TetId t = complex.neighbor(star[k], i);
      if (std::find(star.begin(), star.end(), t) == star.end()) star.push_back(t);
    }
  }
  return star;
}

/// The flip with the smallest circumsphere that brings a hidden vertex out: of a tetrahedron whose
/// facet opposite the vertex is on the boundary. kNoTet if there is none.
TetId exposing_flip(const TetComplex& complex, const Circumspheres& spheres, VertexId v,
                    const Flags& solid) {
  TetId best = kNoTet;
  const auto better = [&](TetId t) {
    if (best == kNoTet || spheres.radius(t) < spheres.radius(best)) return true;
    return spheres.radius(t) == spheres.radius(best) && t < best;
  };
  for (const TetId t : star_of(complex, v)) {
    if (!complex.finite(t)) continue;
    const TetId beyond = complex.neighbor(t, corner_of(complex.vertices(t), v));
    if (solid[+beyond] != solid[+t] && better(t)) best = t;
  }
  return best;
}

}  // namespace

void deform_towards(Boundary& boundary, const Circumspheres& spheres, const Flags& wanted,
                    FlipOrder order) {
  struct Entry {
    double key;
    TetId tet;
  };
  const TetComplex& complex = boundary.complex();
  const double sign = order == FlipOrder::kSmallestFirst ? 1 : -1;
  const auto later = [&](const Entry& a, const Entry& b) {
    return a.key != b.key ? a.key > b.key
                          : corners_less(complex.vertices(b.tet), complex.vertices(a.tet));
  };
  std::priority_queue<Entry, std::vector<Entry>, decltype(later)> queue(later);
  const auto push = [&](TetId t) {
    if (boundary.solid()[+t] != wanted[+t] && flippable(boundary, t)) {
      queue.push({sign * spheres.radius(t), t});
    }
  };
  for (std::uint32_t t = 0; t < complex.finite_tet_count(); ++t) push(TetId{t});
  while (!queue.empty()) {
    const Entry entry = queue.top();
    queue.pop();
    if (boundary.solid()[+entry.tet] == wanted[+entry.tet]) continue;
    const Exposure e = exposure(boundary, entry.tet);
    if (!e.removable) continue;
    boundary.flip(entry.tet);
    for (int i = 0; i < 4; ++i) push(complex.neighbor(entry.tet, i));
    // The edge between two boundary faces leaves the boundary, which may free others around it.
    if (e.faces == 2) {
      complex.turn(complex.edge(entry.tet, 5 - e.opposite_edge), [&](Facet f, VertexId) {
        push(f.tet);
        return true;
      });
    }
  }
}

std::vector<VertexId> expose_hidden(const TetComplex& complex, const Circumspheres& spheres,
                                    std::vector<VertexId> hidden, Flags& solid) {
  for (bool progress = true; progress;) {
    progress = false;
    std::erase_if(hidden, [&](VertexId v) {
      const TetId t = exposing_flip(complex, spheres, v, solid);
      if (t == kNoTet) return false;
      solid[+t] ^= 1;
      progress = true;
      return true;
    });
  }
  return hidden;
}

}  // namespace tetsculpt
