#include "sculpt/labels.h"

#include <algorithm>
#include <cmath>

#include "sculpt/min_cut.h"

namespace tetsculpt {
namespace {

/// Energies are rounded to this many units, so that cuts are exact and unique.
constexpr double kUnitsPerCost = 1 << 20;
/// How strongly a pole insists at first; the strength doubles with every round.
constexpr double kInsistence = 1.0;
constexpr int kRounds = 6;

MinCut::Capacity units(double cost) { return std::llround(cost * kUnitsPerCost); }

enum class Side { kBoth, kOnlyInside, kOnlyOutside };

Side side(std::span<const TetId> star, const Flags& inside) {
  bool in = false;
  bool out = false;
  for (const TetId t : star) (inside[+t] ? in : out) = true;
  return in && out ? Side::kBoth : in ? Side::kOnlyInside : Side::kOnlyOutside;
}

/// The tetrahedron at v that is the best candidate for the side it lacks.
TetId candidate(VertexId v, bool inside, std::span<const TetId> star, const TetComplex& complex,
                const Evidence& evidence) {
  const auto& believed = evidence.believed[+v];
  if (believed.inside != believed.outside) return inside ? believed.inside : believed.outside;
  const auto rank = [&](TetId t) {
    if (!complex.finite(t)) return -HUGE_VAL;
    return inside ? evidence.inside_bias[+t] : -evidence.inside_bias[+t];
  };
  return *std::max_element(star.begin(), star.end(),
                           [&](TetId a, TetId b) { return rank(a) < rank(b); });
}

}  // namespace

Labels cut_labels(const TetComplex& complex, const VertexStars& stars, Evidence& evidence) {
  MinCut cut(complex);
  for (std::uint32_t t = 0; t < complex.triangle_count(); ++t) {
    cut.set_facet(TriangleId{t}, units(evidence.facet_cost[t]));
  }
  for (std::uint32_t t = 0; t < complex.finite_tet_count(); ++t) {
    cut.add_inside_bias(TetId{t}, units(evidence.inside_bias[t]));
  }
  Labels labels;
  labels.likely = cut.solve();
  labels.wanted = labels.likely;
  std::vector<double> insistence(complex.vertex_count(), kInsistence);
  for (int round = 0; round < kRounds; ++round) {
    bool changed = false;
    for (std::uint32_t v = 0; v < complex.vertex_count(); ++v) {
      const auto star = stars(VertexId{v});
      const Side now = side(star, labels.wanted);
      if (now == Side::kBoth) continue;
      const bool inside = now == Side::kOnlyOutside;
      const TetId pole = candidate(VertexId{v}, inside, star, complex, evidence);
      if (!complex.finite(pole)) continue;
      const double bias = inside ? insistence[v] : -insistence[v];
      insistence[v] *= 2;
      evidence.inside_bias[+pole] += bias;
      cut.add_inside_bias(pole, units(bias));
      changed = true;
    }
    if (!changed) break;
    labels.wanted = cut.solve();
  }
  return labels;
}

}  // namespace tetsculpt
