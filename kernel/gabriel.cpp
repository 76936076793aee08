// An edge is a Gabriel edge unless a corner p of one of its tetrahedra lies in its diametral
// sphere: unless (a - p).(b - p) is negative. One pass over the tetrahedra makes the twelve such
// tests of each from one Gram matrix, with one error bound for all: a fifth of the time of turning
// around every edge.
#include "kernel/gabriel.h"

#include <array>
#include <atomic>
#include <bit>
#include <cfloat>

#include "kernel/gram.h"
#include "kernel/parallel.h"
#include "kernel/perturbation.h"

namespace tetsculpt {
namespace {

constexpr std::size_t kProducts = 12;

/// The corner whose product with edge i % 6 is number i: of the edge's two opposite corners the
/// first, then the second.
constexpr std::size_t corner_of_product(std::size_t i) { return kEdgeCorners[5 - i % 6][i / 6]; }

/// (a - p).(b - p) for every edge ab of a tetrahedron and every other corner p.
///
/// All are sums of at most four entries of the Gram matrix, each off by 5 u M; at most three sums
/// of partial sums below 4 M add 12 u M. In all 32 u M and terms of second order.
std::array<double, kProducts> corner_products(const Gram& g) {
  return {g.g22 - g.g12,
          g.g11 - g.g12,
          g.g11 - g.g13,
          g.g12,
          g.g13,
          g.g23,  //
          g.g33 - g.g13,
          g.g33 - g.g23,
          g.g22 - g.g23,  //
          (g.g12 - g.g13) + (g.g33 - g.g23),
          (g.g13 - g.g12) + (g.g22 - g.g23),
          (g.g23 - g.g12) + (g.g11 - g.g13)};
}

double product_error(const Gram& g) { return 17 * DBL_EPSILON * g.largest(); }

/// Unmarks the edges of a tetrahedron in whose diametral spheres its other corners lie. Threads may
/// meet at an edge; they only ever take the mark away.
void unmark_non_gabriel(std::span<const Point3> points, const TetComplex& complex, TetId t,
                        Flags& gabriel) {
  const auto& v = complex.vertices(t);
  const Gram g = gram(points, v);
  const SignBits signs = sign_bits(corner_products(g), product_error(g));
  const auto mark = [&](int edge) { return std::atomic_ref(gabriel[+complex.edge(t, edge)]); };
  for (std::uint32_t hit = (signs.negative | signs.negative >> 6) & 63; hit != 0; hit &= hit - 1) {
    mark(std::countr_zero(hit)).store(0, std::memory_order_relaxed);
  }
  for (std::uint32_t left = signs.doubtful; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    const auto edge = mark(static_cast<int>(i % 6));
    if (!edge.load(std::memory_order_relaxed)) continue;
    const auto [a, b] = kEdgeCorners[i % 6];
    if (in_perturbed_diametral_sphere(points[+v[a]], points[+v[b]],
                                      points[+v[corner_of_product(i)]])) {
      edge.store(0, std::memory_order_relaxed);
    }
  }
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

}  // namespace tetsculpt
