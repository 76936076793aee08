// One cut labels a well-sampled surface: its boundary is a 2-manifold through all vertices as it
// stands, and nothing is left to do. Elsewhere a few vertices have all their tetrahedra on one
// side. Around these the nodes are taken apart into single tetrahedra, one pole of each insists on
// the side that is missing, and the cut is made again.
#include "sculpt/labels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "sculpt/min_cut.h"

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

std::size_t weight(const StarFaults& faults) {
  return faults.hidden.size() + kBadStarFaults * faults.bad.size();
}

/// Labels of nodes as labels of tetrahedra.
Flags expanded(const LabelGraph& graph, const Flags& inside) {
  Flags labels(graph.node_of_tet.size());
  for (std::size_t t = 0; t < labels.size(); ++t) labels[t] = inside[graph.node_of_tet[t]];
  return labels;
}

/// What it costs, per arc, to cut it.
LargeArray<MinCut::Capacity> capacities(const LabelGraph& graph, const Evidence& evidence) {
  LargeArray<MinCut::Capacity> capacity(graph.arcs.size());
  for (std::size_t a = 0; a < capacity.size(); ++a) {
    const LabelGraph::Arc& arc = graph.arcs[a];
    capacity[a] =
        arc.mate < a ? capacity[arc.mate] : units(evidence.facet_cost(arc.triangle, arc.overlap));
  }
  return capacity;
}

/// A label graph with the cut over it.
class GraphCut {
 public:
  GraphCut(const TetComplex& complex, const LabelGraph& graph, const Evidence& evidence)
      : complex_(complex), graph_(graph), cut_(graph, capacities(graph, evidence)) {
    LargeArray<double> bias(graph.node_count(), 0);
    for (std::size_t t = 0; t < complex.finite_tet_count(); ++t) {
      bias[graph.node_of_tet[t]] += evidence.inside_bias[t];
    }
    for (LabelGraph::Node x = 1; x < bias.size(); ++x) cut_.add_inside_bias(x, units(bias[x]));
  }

  void insist(TetId t, double bias) {
    const LabelGraph::Node x = graph_.node_of_tet[+t];
    if (x != LabelGraph::kOutside) cut_.add_inside_bias(x, units(bias));
  }
  void solve() { inside_ = &cut_.solve(); }
  const Flags& inside() const { return *inside_; }

  StarFaults faults() const {
    std::vector<std::array<VertexId, 3>> triangles;
    triangles.reserve(2 * complex_.vertex_count());
    for (LabelGraph::Node x = 1; x < graph_.node_count(); ++x) {
      if (!(*inside_)[x]) continue;
      for (const LabelGraph::Arc& arc : graph_.arcs_of(x)) {
        if ((*inside_)[arc.head]) continue;
        auto corners = complex_.vertices(arc.triangle);
        if (graph_.node_of_tet[+complex_.facet(arc.triangle).tet] != x) {
          std::swap(corners[1], corners[2]);
        }
        triangles.push_back(corners);
      }
    }
    return star_faults(complex_.vertex_count(), triangles);
  }

 private:
  const TetComplex& complex_;
  const LabelGraph& graph_;
  MinCut cut_;
  const Flags* inside_ = nullptr;
};

/// The tetrahedron at v that is the best candidate for the side it lacks.
TetId candidate(VertexId v, bool inside, std::span<const TetId> star, const TetComplex& complex,
                const Evidence& evidence) {
  const auto& believed = evidence.believed[+v];
  if (believed.inside != believed.outside) return inside ? believed.inside : believed.outside;
  const auto rank = [&](TetId t) {
    if (!complex.finite(t)) return -HUGE_VALF;
    return inside ? evidence.inside_bias[+t] : -evidence.inside_bias[+t];
  };
  return *std::max_element(star.begin(), star.end(),
                           [&](TetId a, TetId b) { return rank(a) < rank(b); });
}

/// Gives up the parts, solid or hollow, most of whose tetrahedra had another label at first: pieces
/// that insistence alone made. Their vertices are brought back later, without a new shell.
void drop_unsupported_parts(const LabelGraph& graph, const Flags& at_first, Flags& inside) {
  Flags seen(graph.node_count(), 0);
  std::vector<LabelGraph::Node> part;
  for (LabelGraph::Node first = 0; first < graph.node_count(); ++first) {
    if (seen[first]) continue;
    std::size_t supported = 0;
    std::size_t size = 0;
    seen[first] = 1;
    part.assign(1, first);
    for (std::size_t k = 0; k < part.size(); ++k) {
      const LabelGraph::Node x = part[k];
      size += graph.tets_in[x];
      if (at_first[x] == inside[x]) supported += graph.tets_in[x];
      for (const LabelGraph::Arc& arc : graph.arcs_of(x)) {
        if (seen[arc.head] || inside[arc.head] != inside[first]) continue;
        seen[arc.head] = 1;
        part.push_back(arc.head);
      }
    }
    if (2 * supported >= size) continue;
    for (const LabelGraph::Node x : part) inside[x] ^= 1;
  }
}

/// Takes nodes apart around faulty vertices and cuts again while poles insist.
class Refinement {
 public:
  Refinement(const TetComplex& complex, const VertexStars& stars, Flags alone,
             const Evidence& evidence)
      : complex_(complex),
        stars_(stars),
        evidence_(evidence),
        alone_(std::move(alone)),
        insistence_(complex.vertex_count(), kInsistence) {}

  RefinedLabels run(const StarFaults& coarse, const std::function<void(double)>& progress) {
    isolate(coarse.hidden);
    isolate(coarse.bad);
    graph_ = label_graph(complex_, evidence_.overlap, alone_);
    GraphCut cut(complex_, graph_, evidence_);
    RefinedLabels labels;
    Flags at_first, best;
    std::size_t least_faults = SIZE_MAX;
    for (int round = 0; round <= kRounds; ++round) {
      if (progress) progress(static_cast<double>(round + 1) / (kRounds + 2));
      cut.solve();
      if (round == 0) at_first = cut.inside();
      const StarFaults faults = cut.faults();
      if (weight(faults) < least_faults) {
        least_faults = weight(faults);
        best = cut.inside();
      }
      if (round == kRounds || !insist(faults.hidden, cut)) break;
    }
    labels.first = expanded(graph_, at_first);
    labels.wanted = expanded(graph_, cut.inside());
    drop_unsupported_parts(graph_, at_first, best);
    labels.likely = expanded(graph_, best);
    return labels;
  }

 private:
  void isolate(const std::vector<VertexId>& vertices) {
    for (const VertexId v : vertices) {
      for (const TetId t : stars_(v)) {
        for (const VertexId u : complex_.vertices(t)) {
          if (u == kInfinite) continue;
          for (const TetId s : stars_(u)) alone_[+s] = 1;
        }
      }
    }
  }

  /// One pole of each hidden vertex insists on the other side, more strongly every time.
  bool insist(const std::vector<VertexId>& hidden, GraphCut& cut) {
    bool any = false;
    const Flags inside = cut.inside();
    for (const VertexId v : hidden) {
      const bool towards_inside = !inside[graph_.node_of_tet[+stars_(v)[0]]];
      const TetId pole = candidate(v, towards_inside, stars_(v), complex_, evidence_);
      if (!complex_.finite(pole)) continue;
      const double bias = towards_inside ? insistence_[+v] : -insistence_[+v];
      insistence_[+v] *= 2;
      cut.insist(pole, bias);
      any = true;
    }
    return any;
  }

  const TetComplex& complex_;
  const VertexStars& stars_;
  const Evidence& evidence_;
  Flags alone_;
  LabelGraph graph_;
  std::vector<double> insistence_;
};

}  // namespace

CutLabels cut_labels(const TetComplex& complex, const LabelGraph& graph, const Evidence& evidence) {
  GraphCut cut(complex, graph, evidence);
  cut.solve();
  return {expanded(graph, cut.inside()), cut.faults()};
}

RefinedLabels refined_labels(const TetComplex& complex, const VertexStars& stars, Flags alone,
                             const StarFaults& faults, const Evidence& evidence,
                             const std::function<void(double)>& progress) {
  return Refinement(complex, stars, std::move(alone), evidence).run(faults, progress);
}

}  // namespace tetsculpt
