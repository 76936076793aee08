#include "sculpt/labels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "sculpt/min_cut.h"
#include "sculpt/star_inspector.h"

namespace tetsculpt {
namespace {

/// Energies are rounded to this many units, so that cuts are exact and unique.
constexpr double kUnitsPerCost = 1 << 20;
/// How strongly a pole insists at first; the strength doubles with every round.
constexpr double kInsistence = 1.0;
constexpr int kRounds = 6;
/// A bad star counts as much as so many vertices with all tetrahedra on one side.
constexpr std::size_t kBadStarFaults = 3;

MinCut::Capacity units(double cost) { return std::llround(cost * kUnitsPerCost); }

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

/// Gives up the parts, solid or hollow, that have no tetrahedron with the label it had at first:
/// pieces that insistence alone made. Their vertices are brought back later, without a new shell.
void drop_unsupported_parts(const TetComplex& complex, const Flags& at_first, Flags& inside) {
  Flags seen(complex.tet_count(), 0);
  std::vector<TetId> part;
  for (std::uint32_t first = 0; first < complex.tet_count(); ++first) {
    if (seen[first]) continue;
    std::size_t supported = 0;
    seen[first] = 1;
    part.assign(1, TetId{first});
    for (std::size_t k = 0; k < part.size(); ++k) {
      supported += at_first[+part[k]] == inside[+part[k]];
      for (int i = 0; i < 4; ++i) {
        const TetId u = complex.neighbor(part[k], i);
        if (seen[+u] || inside[+u] != inside[first]) continue;
        seen[+u] = 1;
        part.push_back(u);
      }
    }
    if (2 * supported >= part.size()) continue;
    for (const TetId t : part) inside[+t] ^= 1;
  }
}

/// Cuts, and cuts again while vertices have all their tetrahedra on one side.
class Cutter {
 public:
  Cutter(const TetComplex& complex, const VertexStars& stars, Evidence& evidence)
      : complex_(complex),
        stars_(stars),
        evidence_(evidence),
        inspector_(complex, stars),
        cut_(complex),
        insistence_(complex.vertex_count(), kInsistence) {
    for (std::uint32_t t = 0; t < complex.triangle_count(); ++t) {
      cut_.set_facet(TriangleId{t}, units(evidence.facet_cost[t]));
    }
    for (std::uint32_t t = 0; t < complex.finite_tet_count(); ++t) {
      cut_.add_inside_bias(TetId{t}, units(evidence.inside_bias[t]));
    }
  }

  Labels run() {
    Labels labels;
    Flags at_first;
    std::size_t least_faults = SIZE_MAX;
    for (int round = 0; round <= kRounds; ++round) {
      labels.wanted = cut_.solve();
      if (round == 0) at_first = labels.wanted;
      const std::size_t faults = count_faults(labels.wanted);
      if (faults < least_faults) {
        least_faults = faults;
        labels.likely = labels.wanted;
      }
      if (round == kRounds || !insist(labels.wanted)) break;
    }
    drop_unsupported_parts(complex_, at_first, labels.likely);
    return labels;
  }

 private:
  /// Also lists the one-sided vertices.
  std::size_t count_faults(const Flags& inside) {
    one_sided_.clear();
    std::size_t bad_stars = 0;
    for (std::uint32_t v = 0; v < complex_.vertex_count(); ++v) {
      const StarParts parts = inspector_.parts(VertexId{v}, inside);
      if (parts.one_sided()) one_sided_.push_back(VertexId{v});
      bad_stars += parts.excess() > 0;
    }
    return one_sided_.size() + kBadStarFaults * bad_stars;
  }

  /// One pole of each one-sided vertex insists on the other side, more strongly every time.
  bool insist(const Flags& inside) {
    bool any = false;
    for (const VertexId v : one_sided_) {
      const bool towards_inside = !inside[+stars_(v)[0]];
      const TetId pole = candidate(v, towards_inside, stars_(v), complex_, evidence_);
      if (!complex_.finite(pole)) continue;
      const double bias = towards_inside ? insistence_[+v] : -insistence_[+v];
      insistence_[+v] *= 2;
      evidence_.inside_bias[+pole] += bias;
      cut_.add_inside_bias(pole, units(bias));
      any = true;
    }
    return any;
  }

  const TetComplex& complex_;
  const VertexStars& stars_;
  Evidence& evidence_;
  StarInspector inspector_;
  MinCut cut_;
  std::vector<double> insistence_;
  std::vector<VertexId> one_sided_;
};

}  // namespace

Labels cut_labels(const TetComplex& complex, const VertexStars& stars, Evidence& evidence) {
  return Cutter(complex, stars, evidence).run();
}

}  // namespace tetsculpt
