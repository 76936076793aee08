// The paper's "smallest sphere of three points" is read as the smallest circumscribing sphere,
// centred in their plane; the smallest enclosing ball would admit triangles that are not in the
// complex.
//
// The apex of a tetrahedron over a facet lies in that sphere iff the circumcentre lies beyond the
// facet, iff its barycentric coordinate of the apex is negative. All four follow from one Gram
// matrix. Three passes over the tetrahedra, which share what their four facets need of their six
// edges: half the time of a pass over triangles with a sphere test each.
#include "kernel/egh.h"

#include <array>
#include <bit>
#include <cfloat>
#include <cstdint>

#include "kernel/gram.h"
#include "kernel/perturbation.h"

namespace tetsculpt {
namespace {

/// The three edges of each facet, as bits.
constexpr std::array<std::uint32_t, 4> kFacetEdges = [] {
  std::array<std::uint32_t, 4> edges{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 6; ++k) {
      if (kEdgeCorners[k][0] != i && kEdgeCorners[k][1] != i) edges[i] |= 1u << k;
    }
  }
  return edges;
}();

/// Per set of edges, as bits, the facets (as bits) of which `kMissing` edges are not in the set.
template <int kMissing>
constexpr std::array<std::uint8_t, 64> kFacetsMissing = [] {
  std::array<std::uint8_t, 64> facets{};
  for (std::uint32_t edges = 0; edges < 64; ++edges) {
    for (std::size_t i = 0; i < 4; ++i) {
      const bool counts = std::popcount(kFacetEdges[i] & ~edges) == kMissing;
      facets[edges] = static_cast<std::uint8_t>(facets[edges] | std::uint32_t{counts} << i);
    }
  }
  return facets;
}();

/// The flagged edges of a tetrahedron, as bits.
std::uint32_t flagged_edges(const TetComplex& complex, TetId t, const Flags& flags) {
  std::uint32_t bits = 0;
  for (int k = 0; k < 6; ++k) bits |= std::uint32_t{flags[+complex.edge(t, k)]} << k;
  return bits;
}

/// The circumcentre's barycentric coordinates, times twice the determinant of the Gram matrix.
///
/// With M = 1 the true entries, minors and the determinant of the matrix are at most 1 in
/// magnitude. Errors in u: entries 5; minors 2 (5 + 5 + 1) + 2 = 24; a product of both 24 + 5 + 1 =
/// 30; a sum of three such 90 + 5 = 95, which is coordinates 1 to 3 and the determinant; coordinate
/// 0 has 2 * 95 + 3 * 95 and four roundings of at most 11: 519, and terms of second order.
std::array<double, 4> circumcentre(const Gram& g) {
  const double a11 = g.g22 * g.g33 - g.g23 * g.g23;
  const double a22 = g.g11 * g.g33 - g.g13 * g.g13;
  const double a33 = g.g11 * g.g22 - g.g12 * g.g12;
  const double a12 = g.g13 * g.g23 - g.g12 * g.g33;
  const double a13 = g.g12 * g.g23 - g.g13 * g.g22;
  const double a23 = g.g12 * g.g13 - g.g11 * g.g23;
  const double one = a11 * g.g11 + a12 * g.g22 + a13 * g.g33;
  const double two = a12 * g.g11 + a22 * g.g22 + a23 * g.g33;
  const double three = a13 * g.g11 + a23 * g.g22 + a33 * g.g33;
  const double determinant = a11 * g.g11 + a12 * g.g12 + a13 * g.g13;
  return {2 * determinant - (one + two + three), one, two, three};
}

double circumcentre_error(const Gram& g) {
  const double m = g.largest();
  return 264 * DBL_EPSILON * (m * m * m);
}

/// Of the given facets (as bits) those in whose smallest circumscribing sphere the tetrahedron's
/// own apex lies.
std::uint32_t with_apex_inside(std::span<const Point3> points, const std::array<VertexId, 4>& v,
                               std::uint32_t facets) {
  const Gram g = gram(points, v);
  const SignBits signs = sign_bits(circumcentre(g), circumcentre_error(g));
  std::uint32_t inside = signs.negative & facets;
  for (std::uint32_t left = signs.doubtful & facets; left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const auto& c = kFacetCorners[static_cast<std::size_t>(i)];
    const bool in =
        in_perturbed_equatorial_sphere(points[+v[c[0]]], points[+v[c[1]]], points[+v[c[2]]],
                                       points[+v[static_cast<std::size_t>(i)]]);
    inside |= std::uint32_t{in} << i;
  }
  return inside;
}

/// Per finite tetrahedron, as bits: the facets with two Gabriel edges in whose sphere its apex does
/// not lie.
Flags half_empty_facets(std::span<const Point3> points, const TetComplex& complex,
                        const Flags& gabriel) {
  Flags facets(complex.finite_tet_count());
  for (std::uint32_t t = 0; t < facets.size(); ++t) {
    const std::uint32_t two = kFacetsMissing<1>[flagged_edges(complex, TetId{t}, gabriel)];
    facets[t] = two == 0 ? 0
                         : static_cast<std::uint8_t>(
                               two & ~with_apex_inside(points, complex.vertices(TetId{t}), two));
  }
  return facets;
}

}  // namespace

Egh extended_gabriel_hypergraph(std::span<const Point3> points, const TetComplex& complex,
                                const Flags& gabriel) {
  Egh egh{gabriel, Flags(complex.triangle_count())};
  const Flags half_empty = half_empty_facets(points, complex, gabriel);
  for (std::uint32_t i = 0; i < half_empty.size(); ++i) {
    const TetId t{i};
    for (std::uint32_t left = half_empty[i]; left != 0; left &= left - 1) {
      const int facet = std::countr_zero(left);
      const Facet other = complex.across(t, facet);
      if (complex.finite(other.tet) && !(half_empty[+other.tet] >> other.corner & 1)) continue;
      const std::uint32_t edges = kFacetEdges[static_cast<std::size_t>(facet)];
      const std::uint32_t third = edges & ~flagged_edges(complex, t, gabriel);
      egh.edges[+complex.edge(t, std::countr_zero(third))] = 1;
    }
  }
  for (std::uint32_t i = 0; i < half_empty.size(); ++i) {
    const TetId t{i};
    const std::uint32_t whole = kFacetsMissing<0>[flagged_edges(complex, t, egh.edges)];
    for (int facet = 0; facet < 4; ++facet) {
      egh.triangles[+complex.triangle(t, facet)] = whole >> facet & 1;
    }
  }
  return egh;
}

}  // namespace tetsculpt
