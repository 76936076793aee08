// The paper's "smallest sphere of three points" is read as the smallest circumscribing sphere,
// centred in their plane; the smallest enclosing ball would admit triangles that are not in the
// complex.
#include "kernel/gabriel.h"

#include "kernel/parallel.h"
#include "kernel/perturbation.h"

namespace tetsculpt {
namespace {

bool is_gabriel(std::span<const Point3> points, const TetComplex& complex, EdgeId e) {
  const Point3& a = points[+complex.vertices(e)[0]];
  const Point3& b = points[+complex.vertices(e)[1]];
  bool empty = true;
  complex.turn(e, [&](Facet, VertexId third) {
    empty = third == kInfinite || !in_perturbed_diametral_sphere(a, b, points[+third]);
    return empty;
  });
  return empty;
}

bool has_empty_sphere(std::span<const Point3> points, const TetComplex& complex, TriangleId t) {
  const auto [a, b, c] = complex.vertices(t);
  const Facet inner = complex.facet(t);
  const Facet outer = complex.across(inner.tet, inner.corner);
  for (const Facet side : {inner, outer}) {
    const VertexId apex = complex.vertices(side.tet)[static_cast<std::size_t>(side.corner)];
    if (apex != kInfinite &&
        in_perturbed_equatorial_sphere(points[+a], points[+b], points[+c], points[+apex])) {
      return false;
    }
  }
  return true;
}

}  // namespace

Flags gabriel_edges(std::span<const Point3> points, const TetComplex& complex, int threads) {
  Flags gabriel(complex.edge_count());
  parallel_ranges(gabriel.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      gabriel[e] = is_gabriel(points, complex, EdgeId{static_cast<std::uint32_t>(e)});
    }
  });
  return gabriel;
}

Egh extended_gabriel_hypergraph(std::span<const Point3> points, const TetComplex& complex,
                                const Flags& gabriel) {
  Egh egh{gabriel, Flags(complex.triangle_count(), 0)};
  for (std::uint32_t t = 0; t < complex.triangle_count(); ++t) {
    const auto edges = complex.edges(TriangleId{t});
    const int count = gabriel[+edges[0]] + gabriel[+edges[1]] + gabriel[+edges[2]];
    if (count != 2 || !has_empty_sphere(points, complex, TriangleId{t})) continue;
    for (const EdgeId e : edges) egh.edges[+e] = 1;
  }
  for (std::uint32_t t = 0; t < complex.triangle_count(); ++t) {
    const auto [a, b, c] = complex.edges(TriangleId{t});
    egh.triangles[t] = egh.edges[+a] && egh.edges[+b] && egh.edges[+c];
  }
  return egh;
}

}  // namespace tetsculpt
