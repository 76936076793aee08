// The paper's "smallest sphere of three points" is read as the smallest circumscribing sphere,
// centred in their plane; the smallest enclosing ball would admit triangles that are not in the
// complex.
//
// Gabriel edges: a link vertex p of edge ab lies in its diametral sphere iff (a - p).(b - p) is
// negative. One pass over the tetrahedra makes the twelve such tests of each from one Gram matrix,
// with one error bound for all: a fifth of the time of turning around every edge.
#include "kernel/gabriel.h"

#include <array>
#include <atomic>
#include <bit>
#include <cfloat>

#include "kernel/parallel.h"
#include "kernel/perturbation.h"
#include "kernel/vec3.h"

namespace tetsculpt {
namespace {

/// (a - p).(b - p) for every corner p of a tetrahedron and every two others a, b.
///
/// With e_i the rounded differences of corners 1, 2, 3 from corner 0, all are sums of at most four
/// entries of the Gram matrix G_ij = e_i.e_j. Per product, two differences, the product and two
/// sums are rounded, so by Cauchy-Schwarz G_ij is off by at most 5 u M, M the largest G_ii; at
/// most three sums of partial sums below 4 M add 12 u M. In all 32 u M and terms of second order:
/// 34 u (G_11 + G_22 + G_33) is enough.
struct CornerProducts {
  /// [3 p + k] belongs to corner p and edge k of the facet opposite it: the edge opposite, in that
  /// facet, to the k-th corner of kFacetCorners[p].
  std::array<double, 12> value;
  double error;
};

CornerProducts corner_products(const std::array<const Point3*, 4>& p) {
  const auto from_first = [&](std::size_t i) {
    return Vec3<double>{p[i]->x - p[0]->x, p[i]->y - p[0]->y, p[i]->z - p[0]->z};
  };
  const Vec3<double> e1 = from_first(1);
  const Vec3<double> e2 = from_first(2);
  const Vec3<double> e3 = from_first(3);
  const double g11 = dot(e1, e1);
  const double g22 = dot(e2, e2);
  const double g33 = dot(e3, e3);
  const double g12 = dot(e1, e2);
  const double g13 = dot(e1, e3);
  const double g23 = dot(e2, e3);
  // Rows follow kFacetCorners: {1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}.
  return {{g23, g12, g13,                                    //
           (g23 - g12) + (g11 - g13), g11 - g13, g11 - g12,  //
           (g13 - g12) + (g22 - g23), g22 - g12, g22 - g23,  //
           (g12 - g13) + (g33 - g23), g33 - g23, g33 - g13},
          17 * DBL_EPSILON * (g11 + g22 + g33)};
}

/// Unmarks the edges of a tetrahedron in whose diametral spheres its other corners lie.
void unmark_non_gabriel(std::span<const Point3> points, const TetComplex& complex, TetId t,
                        Flags& gabriel) {
  const auto& v = complex.vertices(t);
  const CornerProducts products =
      corner_products({&points[+v[0]], &points[+v[1]], &points[+v[2]], &points[+v[3]]});
  // Signs come without order, and a branch on each would often be mispredicted: collect them first.
  std::uint32_t in_question = 0;
  for (std::size_t i = 0; i < 12; ++i) {
    in_question |= std::uint32_t{products.value[i] <= products.error} << i;
  }
  for (; in_question != 0; in_question &= in_question - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(in_question));
    const std::size_t p = i / 3;
    const std::uint8_t a = kFacetCorners[p][(i + 1) % 3];
    const std::uint8_t b = kFacetCorners[p][(i + 2) % 3];
    // Threads may meet at an edge; they only ever take the mark away.
    const std::atomic_ref<std::uint8_t> mark(gabriel[+complex.edge(t, kEdgeOfCorners[a][b])]);
    if (!mark.load(std::memory_order_relaxed)) continue;
    if (products.value[i] < -products.error ||
        in_perturbed_diametral_sphere(points[+v[a]], points[+v[b]], points[+v[p]])) {
      mark.store(0, std::memory_order_relaxed);
    }
  }
}

/// Neither apex of the facet lies in its smallest circumscribing sphere.
bool has_empty_sphere(std::span<const Point3> points, const TetComplex& complex, Facet f) {
  const auto& c = kFacetCorners[static_cast<std::size_t>(f.corner)];
  const auto& v = complex.vertices(f.tet);
  for (const Facet side : {f, complex.across(f.tet, f.corner)}) {
    const VertexId apex = complex.vertices(side.tet)[static_cast<std::size_t>(side.corner)];
    if (apex != kInfinite && in_perturbed_equatorial_sphere(points[+v[c[0]]], points[+v[c[1]]],
                                                            points[+v[c[2]]], points[+apex])) {
      return false;
    }
  }
  return true;
}

}  // namespace

Flags gabriel_edges(std::span<const Point3> points, const TetComplex& complex, int threads) {
  Flags gabriel(complex.edge_count(), 1);
  parallel_ranges(complex.finite_tet_count(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      unmark_non_gabriel(points, complex, TetId{static_cast<std::uint32_t>(t)}, gabriel);
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
    if (count != 2) continue;
    const EdgeId third = !gabriel[+edges[0]] ? edges[0] : !gabriel[+edges[1]] ? edges[1] : edges[2];
    if (egh.edges[+third]) continue;  // by another triangle
    egh.edges[+third] = has_empty_sphere(points, complex, complex.facet(TriangleId{t}));
  }
  for (std::uint32_t t = 0; t < complex.triangle_count(); ++t) {
    const auto [a, b, c] = complex.edges(TriangleId{t});
    egh.triangles[t] = egh.edges[+a] & egh.edges[+b] & egh.edges[+c];
  }
  return egh;
}

}  // namespace tetsculpt
