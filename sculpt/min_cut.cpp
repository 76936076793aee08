// Y. Boykov, V. Kolmogorov, "An experimental comparison of min-cut/max-flow algorithms for energy
// minimization in vision", IEEE PAMI 26(9), 2004: two search trees, one from each terminal, that
// are kept between augmentations; distances to the roots are cached with time stamps. After more
// bias the tetrahedra concerned are taken out of their trees and planted anew, as in P. Kohli, P.
// H. S. Torr, "Dynamic graph cuts for efficient inference in Markov random fields", IEEE PAMI
// 29(12), 2007.
#include "sculpt/min_cut.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tetsculpt {

MinCut::MinCut(const LabelGraph& graph, LargeArray<Capacity> capacity)
    : graph_(&graph),
      residual_(std::move(capacity)),
      terminal_(graph.node_count(), 0),
      parent_(graph.node_count(), kNoArc),
      tree_(graph.node_count(), kFree),
      stamp_(graph.node_count(), 0),
      distance_(graph.node_count(), 0),
      is_active_(graph.node_count(), 0),
      changed_(graph.node_count() - 1),
      inside_(graph.node_count(), 0) {
  for (Arc a = arcs_begin(LabelGraph::kOutside); a != arcs_end(LabelGraph::kOutside); ++a) {
    terminal_[head(a)] += residual_[a];
  }
  std::iota(changed_.begin(), changed_.end(), Node{1});
}

void MinCut::add_inside_bias(Node x, Capacity bias) {
  terminal_[x] -= bias;
  changed_.push_back(x);
}

/// Makes x a root of the tree that its terminal capacity asks for.
void MinCut::place(Node x) {
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
void MinCut::uproot(Node x) {
  for (Arc a = arcs_begin(x); a != arcs_end(x); ++a) {
    if (!has_arc(a)) continue;
    const Node y = head(a);
    if (tree_[y] == kFree) continue;
    activate(y);
    if (parent_[y] == mate(a)) orphan(y);
  }
  tree_[x] = kFree;
  parent_[x] = kNoArc;
  ++time_;
  adopt_orphans();
}

void MinCut::activate(Node x) {
  if (x == growing_) next_arc_ = arcs_begin(x);
  if (is_active_[x]) return;
  is_active_[x] = 1;
  active_.push_back(x);
}

const Flags& MinCut::solve() {
  for (const Node x : changed_) place(x);
  changed_.clear();
  for (std::size_t k = 0; k < active_.size(); ++k) {
    growing_ = active_[k];
    // An augmentation may open arcs behind it: the last pass must find nothing.
    for (bool augmented = true; augmented;) {
      augmented = false;
      next_arc_ = arcs_begin(growing_);
      while (tree_[growing_] != kFree) {
        const Arc bridge = grow(growing_);
        if (bridge == kNoArc) break;
        augment(bridge);
        augmented = true;
      }
    }
    is_active_[growing_] = 0;
  }
  active_.clear();
  growing_ = LabelGraph::kOutside;
  for (Node x = 1; x < tree_.size(); ++x) inside_[x] = tree_[x] != kOutside;
  return inside_;
}

/// Extends x's tree to free neighbours, from the arc where it left off: a node may have very many.
/// An arc from the outside tree to the inside tree, if there is one that is not saturated, ends the
/// search.
MinCut::Arc MinCut::grow(Node x) {
  for (; next_arc_ != arcs_end(x); ++next_arc_) {
    const Arc a = next_arc_;
    if (!has_arc(a) || residual_towards(tree_[x], a) <= 0) continue;
    const Node y = head(a);
    if (tree_[y] == kFree) {
      tree_[y] = tree_[x];
      parent_[y] = mate(a);
      stamp_[y] = stamp_[x];
      distance_[y] = distance_[x] + 1;
      activate(y);
    } else if (tree_[y] != tree_[x]) {
      return tree_[x] == kOutside ? a : mate(a);
    } else if (stamp_[y] <= stamp_[x] && distance_[y] > distance_[x] + 1) {
      parent_[y] = mate(a);
      stamp_[y] = stamp_[x];
      distance_[y] = distance_[x] + 1;
    }
  }
  return kNoArc;
}

MinCut::Capacity MinCut::bottleneck(Arc bridge) const {
  Capacity flow = residual_[bridge];
  Node x = tail(bridge);
  for (; parent_[x] != kTerminal; x = head(parent_[x])) {
    flow = std::min(flow, residual_[mate(parent_[x])]);
  }
  flow = std::min(flow, terminal_[x]);
  Node y = head(bridge);
  for (; parent_[y] != kTerminal; y = head(parent_[y])) {
    flow = std::min(flow, residual_[parent_[y]]);
  }
  return std::min(flow, -terminal_[y]);
}

/// Sends flow along the path from x to the root of its tree.
void MinCut::push(Node x, Tree tree, Capacity flow) {
  for (;;) {
    const Arc a = parent_[x];
    if (a == kTerminal) {
      terminal_[x] += tree == kOutside ? -flow : flow;
      if (terminal_[x] == 0) orphan(x);
      return;
    }
    const Arc forward = tree == kOutside ? mate(a) : a;
    residual_[forward] -= flow;
    residual_[mate(forward)] += flow;
    const std::uint32_t up = head(a);
    if (residual_[forward] == 0) orphan(x);
    x = up;
  }
}

void MinCut::augment(Arc bridge) {
  const Capacity flow = bottleneck(bridge);
  residual_[bridge] -= flow;
  residual_[mate(bridge)] += flow;
  push(tail(bridge), kOutside, flow);
  push(head(bridge), kInside, flow);
  ++time_;
  adopt_orphans();
}

void MinCut::orphan(Node x) {
  parent_[x] = kNoArc;
  orphans_.push_back(x);
}

void MinCut::adopt_orphans() {
  for (std::size_t k = 0; k < orphans_.size(); ++k) {
    const Node x = orphans_[k];
    if (adopt(x)) continue;
    for (Arc a = arcs_begin(x); a != arcs_end(x); ++a) {
      if (!has_arc(a)) continue;
      const Node y = head(a);
      if (tree_[y] != tree_[x]) continue;
      if (residual_towards(tree_[x], mate(a)) > 0) activate(y);
      if (parent_[y] == mate(a)) orphan(y);
    }
    tree_[x] = kFree;
  }
  orphans_.clear();
}

/// Gives x the parent nearest to a root, if a neighbour in its tree has a way there.
bool MinCut::adopt(Node x) {
  Arc best = kNoArc;
  std::uint32_t best_distance = 0xffffffffu;
  for (Arc a = arcs_begin(x); a != arcs_end(x); ++a) {
    if (!has_arc(a) || tree_[head(a)] != tree_[x]) continue;
    if (residual_towards(tree_[x], mate(a)) <= 0) continue;
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
bool MinCut::origin_distance(Node y, std::uint32_t& distance) {
  std::uint32_t steps = 0;
  for (Node z = y;; z = head(parent_[z])) {
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
  for (Node z = y; stamp_[z] != time_; z = head(parent_[z])) {
    stamp_[z] = time_;
    distance_[z] = steps--;
  }
  return true;
}

}  // namespace tetsculpt
