#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/edge_order.h"
#include "kernel/large_array.h"
#include "sculpt/label_graph.h"

/// Minimum cut between outside and inside over the nodes of a label graph.
namespace tetsculpt {

/// Flow capacities are 64-bit integers, so that the cut is exact; of all minimum cuts solve() takes
/// the one with the smallest outside, which is unique.
class MinCut {
 public:
  using Capacity = std::int64_t;
  using Node = LabelGraph::Node;

  /// `capacity` has the cost of cutting each arc, the same for its mate. Keeps a reference to the
  /// graph.
  MinCut(const LabelGraph& graph, LargeArray<Capacity> capacity);

  /// Adds to the cost that a node has for being outside (negative: for being inside). The node is
  /// not LabelGraph::kOutside.
  void add_inside_bias(Node x, Capacity bias);

  /// The minimum cut, per node: is it inside? May be called again after more bias was added, and
  /// then goes on from the flow it has. Cost: the Boykov-Kolmogorov algorithm; near linear in
  /// practice.
  const Flags& solve();

 private:
  enum Tree : std::uint8_t { kFree, kOutside, kInside };
  using Arc = std::uint32_t;

  /// Arcs to the outside became terminal capacities.
  bool has_arc(Arc a) const { return graph_->arcs[a].head != LabelGraph::kOutside; }
  Node head(Arc a) const { return graph_->arcs[a].head; }
  Arc mate(Arc a) const { return graph_->arcs[a].mate; }
  Node tail(Arc a) const { return head(mate(a)); }
  Arc arcs_begin(Node x) const { return graph_->first[x]; }
  Arc arcs_end(Node x) const { return graph_->first[x + 1]; }
  /// What can still flow from the outer to the inner end of the arc that joins x's tree to y.
  Capacity residual_towards(Tree tree, Arc from_x) const {
    return tree == kOutside ? residual_[from_x] : residual_[mate(from_x)];
  }
  void place(Node x);
  void uproot(Node x);
  void activate(Node x);
  Arc grow(Node x);
  void augment(Arc bridge);
  Capacity bottleneck(Arc bridge) const;
  void push(Node x, Tree tree, Capacity flow);
  void adopt_orphans();
  bool adopt(Node x);
  bool origin_distance(Node y, std::uint32_t& distance);
  void orphan(Node x);

  static constexpr Arc kNoArc = 0xffffffffu;
  static constexpr Arc kTerminal = 0xfffffffeu;

  const LabelGraph* graph_;
  LargeArray<Capacity> residual_;  ///< per arc, what can still flow along it
  LargeArray<Capacity> terminal_;  ///< per node: > 0 from outside, < 0 to inside
  LargeArray<Arc> parent_;         ///< arc towards the root, kTerminal at a root, or kNoArc
  LargeArray<Tree> tree_;
  LargeArray<std::uint32_t> stamp_;      ///< when distance_ was last known to be right
  LargeArray<std::uint32_t> distance_;   ///< to the root
  std::vector<Node> active_;             ///< queue
  Node growing_ = LabelGraph::kOutside;  ///< the active node at work; kOutside is none
  Arc next_arc_ = 0;                     ///< of that node
  Flags is_active_;
  std::vector<Node> orphans_;
  std::vector<Node> changed_;
  std::uint32_t time_ = 0;
  Flags inside_;
};

}  // namespace tetsculpt
