// Evidence for inside and outside, from the points alone.
//
// 1. Bias. A vertex whose poles were guessed to lie on different sides (sculpt/first_guess) has an
//    oriented normal. Each tetrahedron at the vertex is drawn to the side on which its circumcentre
//    lies, by the square of the cosine to the normal; the two poles once more (N. Amenta, S. Choi,
//    R. K. Kolluri, "The power crust", Solid Modeling 2001, for poles as normals).
// 2. Facets. A surface that separates deeply overlapping spheres costs most: ((1 + cos) / 2)^2,
//    plus a little for every facet; less where the facet is a triangle of the EGH, which is likely
//    there (P. Labatut, J.-P. Pons, R. Keriven, "Robust and efficient surface reconstruction from
//    range data", CGF 28(8), 2009, for such costs in a cut).
//
// The weights below were chosen over the closed models of bench/quality.py (figures in
// bench/RESULTS.md); none of them matters by more than two models within a factor of two.
#include "sculpt/evidence.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace tetsculpt {
namespace {

constexpr double kPoleWeight = 0.2;
constexpr double kNormalWeight = 0.4;
constexpr float kFacetWeight = 0.02f;
constexpr float kEghFactor = 0.85f;

/// A vertex and its outward normal, times the root of the strength with which it is believed.
struct OrientedPoint {
  Vec3<double> point;
  Vec3<double> normal;
};

/// Which pole is which; equal where the guess does not tell them apart.
Evidence::Poles told_apart(const PolePair& pair, const LabelGraph& graph,
                           std::span<const Side> guess) {
  const Side first = guess[graph.node_of_tet[+pair.first]];
  const Side second = guess[graph.node_of_tet[+pair.second]];
  if (pair.strength <= 0 || first == second) return {};
  if (first == Side::kInside) return {pair.first, pair.second};
  return {pair.second, pair.first};
}

}  // namespace

float Evidence::facet_cost(TriangleId t, float its_overlap) const {
  const float closeness = (1 + its_overlap) / 2;
  return (kFacetWeight + closeness * closeness) * (egh_triangles[+t] ? kEghFactor : 1);
}

Evidence weigh_evidence(std::span<const Point3> points, const TetComplex& complex,
                        const Circumspheres& spheres, std::span<const PolePair> pairs,
                        const LabelGraph& graph, std::span<const Side> guess,
                        LargeArray<float> overlap, const Flags& egh_triangles) {
  Evidence evidence;
  evidence.overlap = std::move(overlap);
  evidence.egh_triangles = egh_triangles;
  evidence.inside_bias.assign(complex.finite_tet_count(), 0);
  evidence.believed.resize(points.size());
  LargeArray<OrientedPoint> oriented(points.size(), {{0, 0, 0}, {0, 0, 0}});
  const auto draw = [&](TetId pole, double to_inside) {
    if (complex.finite(pole)) evidence.inside_bias[+pole] += static_cast<float>(to_inside);
  };
  for (std::size_t v = 0; v < points.size(); ++v) {
    const Evidence::Poles poles = evidence.believed[v] = told_apart(pairs[v], graph, guess);
    oriented[v].point = as_vector(points[v]);
    if (poles.inside == poles.outside) continue;
    const double strength = pairs[v].strength;
    const double root = std::sqrt(strength);
    oriented[v].normal = pairs[v].axis * (poles.inside == pairs[v].first ? -root : root);
    draw(poles.inside, kPoleWeight * strength);
    draw(poles.outside, -kPoleWeight * strength);
  }
  for (std::uint32_t i = 0; i < complex.finite_tet_count(); ++i) {
    const double radius = spheres.radius(TetId{i});
    if (!std::isfinite(radius) || radius == 0) continue;
    double outward = 0;
    for (const VertexId v : complex.vertices(TetId{i})) {
      const OrientedPoint& at = oriented[+v];
      const double along = dot(from_to(at.point, spheres.centre(TetId{i})), at.normal);
      // In flat tetrahedra the centre is not as far from all corners, by rounding.
      const double cosine = std::clamp(along / radius, -1.0, 1.0);
      outward += cosine * std::fabs(cosine);
    }
    evidence.inside_bias[i] -= static_cast<float>(kNormalWeight * outward);
  }
  return evidence;
}

}  // namespace tetsculpt
