// Y. Boykov, V. Kolmogorov, "An experimental comparison of min-cut/max-flow algorithms for energy
// minimization in vision", IEEE PAMI 26(9), 2004: two search trees, one from each terminal, that
// are kept between augmentations; distances to the roots are cached with time stamps. After more
// bias the tetrahedra concerned are taken out of their trees and planted anew, as in P. Kohli, P.
// H. S. Torr, "Dynamic graph cuts for efficient inference in Markov random fields", IEEE PAMI
// 29(12), 2007.
//
// The graph is the complex itself: nodes are finite tetrahedra, arcs their facets.
#include "sculpt/min_cut.h"

#include <algorithm>

namespace tetsculpt {

MinCut::MinCut(const TetComplex& complex)
    : complex_(&complex),
      mate_(4 * complex.finite_tet_count(), kNoArc),
      residual_(4 * complex.finite_tet_count(), 0),
      terminal_(complex.finite_tet_count(), 0),
      parent_(complex.finite_tet_count(), kNoArc),
      tree_(complex.finite_tet_count(), kFree),
      stamp_(complex.finite_tet_count(), 0),
      distance_(complex.finite_tet_count(), 0),
      is_active_(complex.finite_tet_count(), 0),
      inside_(complex.tet_count(), 0) {
  for (std::uint32_t t = 0; t < complex.finite_tet_count(); ++t) {
    changed_.push_back(t);
    for (int i = 0; i < 4; ++i) {
      const Facet other = complex.across(TetId{t}, i);
      if (!complex.finite(other.tet)) continue;
      mate_[4 * t + static_cast<std::uint32_t>(i)] =
          static_cast<Arc>(4 * +other.tet) + static_cast<Arc>(other.corner);
    }
  }
}

void MinCut::set_facet(TriangleId t, Capacity cost) {
  const Facet f = complex_->facet(t);
  const Arc a = static_cast<Arc>(4 * +f.tet) + static_cast<Arc>(f.corner);
  if (has_arc(a)) {
    residual_[a] = residual_[mate_[a]] = cost;
  } else {
    terminal_[+f.tet] += cost;  // beyond the hull everything is outside
  }
}

void MinCut::add_inside_bias(TetId t, Capacity bias) {
  terminal_[+t] -= bias;
  changed_.push_back(static_cast<std::uint32_t>(+t));
}

/// Makes x a root of the tree that its terminal capacity asks for.
void MinCut::place(std::uint32_t x) {
  if (terminal_[x] == 0) {
    if (parent_[x] == kTerminal) uproot(x);
    return;
  }
  const Tree wanted = terminal_[x] > 0 ? kOutside : kInside;
  if (tree_[x] != kFree && tree_[x] != wanted) uproot(x);
  tree_[x] = wanted;
  parent_[x] = kTerminal;
  stamp_[x] = time_;
  distance_[x] = 1;
  activate(x);
}

/// Frees x; its children look for other parents.
void MinCut::uproot(std::uint32_t x) {
  for (Arc a = 4 * x; a < 4 * x + 4; ++a) {
    if (!has_arc(a)) continue;
    const std::uint32_t y = head(a);
    if (tree_[y] == kFree) continue;
    activate(y);
    if (parent_[y] == mate_[a]) orphan(y);
  }
  tree_[x] = kFree;
  parent_[x] = kNoArc;
  ++time_;
  adopt_orphans();
}

void MinCut::activate(std::uint32_t x) {
  if (is_active_[x]) return;
  is_active_[x] = 1;
  active_.push_back(x);
}

const Flags& MinCut::solve() {
  for (const std::uint32_t x : changed_) place(x);
  changed_.clear();
  while (next_active_ < active_.size()) {
    const std::uint32_t x = active_[next_active_];
    const Arc bridge = tree_[x] == kFree ? kNoArc : grow(x);
    if (bridge != kNoArc) {
      augment(bridge);
      continue;
    }
    is_active_[x] = 0;
    ++next_active_;
  }
  active_.clear();
  next_active_ = 0;
  for (std::uint32_t t = 0; t < tree_.size(); ++t) inside_[t] = tree_[t] != kOutside;
  return inside_;
}

/// Extends x's tree to free neighbours. An arc from the outside tree to the inside tree, if there
/// is one that is not saturated, ends the search.
MinCut::Arc MinCut::grow(std::uint32_t x) {
  for (Arc a = 4 * x; a < 4 * x + 4; ++a) {
    if (!has_arc(a) || residual_towards(tree_[x], a) <= 0) continue;
    const std::uint32_t y = head(a);
    if (tree_[y] == kFree) {
      tree_[y] = tree_[x];
      parent_[y] = mate_[a];
      stamp_[y] = stamp_[x];
      distance_[y] = distance_[x] + 1;
      activate(y);
    } else if (tree_[y] != tree_[x]) {
      return tree_[x] == kOutside ? a : mate_[a];
    } else if (stamp_[y] <= stamp_[x] && distance_[y] > distance_[x] + 1) {
      parent_[y] = mate_[a];
      stamp_[y] = stamp_[x];
      distance_[y] = distance_[x] + 1;
    }
  }
  return kNoArc;
}

MinCut::Capacity MinCut::bottleneck(Arc bridge) const {
  Capacity flow = residual_[bridge];
  std::uint32_t x = bridge >> 2;
  for (; parent_[x] != kTerminal; x = head(parent_[x])) {
    flow = std::min(flow, residual_[mate_[parent_[x]]]);
  }
  flow = std::min(flow, terminal_[x]);
  std::uint32_t y = head(bridge);
  for (; parent_[y] != kTerminal; y = head(parent_[y])) {
    flow = std::min(flow, residual_[parent_[y]]);
  }
  return std::min(flow, -terminal_[y]);
}

/// Sends flow along the path from x to the root of its tree.
void MinCut::push(std::uint32_t x, Tree tree, Capacity flow) {
  for (;;) {
    const Arc a = parent_[x];
    if (a == kTerminal) {
      terminal_[x] += tree == kOutside ? -flow : flow;
      if (terminal_[x] == 0) orphan(x);
      return;
    }
    const Arc forward = tree == kOutside ? mate_[a] : a;
    residual_[forward] -= flow;
    residual_[mate_[forward]] += flow;
    const std::uint32_t up = head(a);
    if (residual_[forward] == 0) orphan(x);
    x = up;
  }
}

void MinCut::augment(Arc bridge) {
  const Capacity flow = bottleneck(bridge);
  residual_[bridge] -= flow;
  residual_[mate_[bridge]] += flow;
  push(bridge >> 2, kOutside, flow);
  push(head(bridge), kInside, flow);
  ++time_;
  adopt_orphans();
}

void MinCut::orphan(std::uint32_t x) {
  parent_[x] = kNoArc;
  orphans_.push_back(x);
}

void MinCut::adopt_orphans() {
  for (std::size_t k = 0; k < orphans_.size(); ++k) {
    const std::uint32_t x = orphans_[k];
    if (adopt(x)) continue;
    for (Arc a = 4 * x; a < 4 * x + 4; ++a) {
      if (!has_arc(a)) continue;
      const std::uint32_t y = head(a);
      if (tree_[y] != tree_[x]) continue;
      if (residual_towards(tree_[x], mate_[a]) > 0) activate(y);
      if (parent_[y] == mate_[a]) orphan(y);
    }
    tree_[x] = kFree;
  }
  orphans_.clear();
}

/// Gives x the parent nearest to a root, if a neighbour in its tree has a way there.
bool MinCut::adopt(std::uint32_t x) {
  Arc best = kNoArc;
  std::uint32_t best_distance = 0xffffffffu;
  for (Arc a = 4 * x; a < 4 * x + 4; ++a) {
    if (!has_arc(a) || tree_[head(a)] != tree_[x]) continue;
    if (residual_towards(tree_[x], mate_[a]) <= 0) continue;
    std::uint32_t distance = 0;
    if (origin_distance(head(a), distance) && distance < best_distance) {
      best_distance = distance;
      best = a;
    }
  }
  if (best == kNoArc) return false;
  parent_[x] = best;
  stamp_[x] = time_;
  distance_[x] = best_distance + 1;
  return true;
}

/// Follows y to its root; false if it ends at an orphan. Remembers the distances on the way.
bool MinCut::origin_distance(std::uint32_t y, std::uint32_t& distance) {
  std::uint32_t steps = 0;
  for (std::uint32_t z = y;; z = head(parent_[z])) {
    if (stamp_[z] == time_ && parent_[z] != kNoArc) {
      steps += distance_[z];
      break;
    }
    if (parent_[z] == kNoArc) return false;
    ++steps;
    if (parent_[z] == kTerminal) {
      stamp_[z] = time_;
      distance_[z] = 1;
      break;
    }
  }
  distance = steps;
  for (std::uint32_t z = y; stamp_[z] != time_; z = head(parent_[z])) {
    stamp_[z] = time_;
    distance_[z] = steps--;
  }
  return true;
}

}  // namespace tetsculpt
