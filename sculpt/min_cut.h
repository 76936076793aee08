#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/edge_order.h"
#include "kernel/ids.h"
#include "kernel/tet_complex.h"

/// Minimum cut between outside and inside over the tetrahedra of a complex.
namespace tetsculpt {

/// Flow capacities are 64-bit integers, so that the cut is exact; of all minimum cuts solve() takes
/// the one with the smallest outside, which is unique.
class MinCut {
 public:
  using Capacity = std::int64_t;

  /// Nothing is connected yet. Keeps a reference to the complex. Infinite tetrahedra are outside.
  explicit MinCut(const TetComplex& complex);

  /// Cost of having the facet between an inside and an outside tetrahedron, for every finite
  /// triangle.
  void set_facet(TriangleId t, Capacity cost);
  /// Adds to the cost that a finite tetrahedron has for being outside (negative: for being inside).
  void add_inside_bias(TetId t, Capacity bias);

  /// The minimum cut, per tetrahedron: is it inside? May be called again after more bias was added,
  /// and then goes on from the flow it has. Cost: the Boykov-Kolmogorov algorithm; near linear in
  /// practice.
  const Flags& solve();

 private:
  enum Tree : std::uint8_t { kFree, kOutside, kInside };
  using Arc = FacetHandle;

  bool has_arc(Arc a) const { return mate_[a] != kNoArc; }
  std::uint32_t head(Arc a) const { return mate_[a] >> 2; }
  /// What can still flow from the outer to the inner end of the arc that joins x's tree to y.
  Capacity residual_towards(Tree tree, Arc from_x) const {
    return tree == kOutside ? residual_[from_x] : residual_[mate_[from_x]];
  }
  void place(std::uint32_t x);
  void uproot(std::uint32_t x);
  void activate(std::uint32_t x);
  Arc grow(std::uint32_t x);
  void augment(Arc bridge);
  Capacity bottleneck(Arc bridge) const;
  void push(std::uint32_t x, Tree tree, Capacity flow);
  void adopt_orphans();
  bool adopt(std::uint32_t x);
  bool origin_distance(std::uint32_t y, std::uint32_t& distance);
  void orphan(std::uint32_t x);

  static constexpr Arc kNoArc = 0xffffffffu;
  static constexpr Arc kTerminal = 0xfffffffeu;

  const TetComplex* complex_;
  std::vector<Arc> mate_;           ///< per facet of a finite tetrahedron, the same from beyond
  std::vector<Capacity> residual_;  ///< per facet, what can flow out through it
  std::vector<Capacity> terminal_;  ///< per tetrahedron: > 0 from outside, < 0 to inside
  std::vector<Arc> parent_;         ///< arc towards the root, kTerminal at a root, or kNoArc
  std::vector<Tree> tree_;
  std::vector<std::uint32_t> stamp_;     ///< when distance_ was last known to be right
  std::vector<std::uint32_t> distance_;  ///< to the root
  std::vector<std::uint32_t> active_;    ///< queue
  std::size_t next_active_ = 0;
  Flags is_active_;
  std::vector<std::uint32_t> orphans_;
  std::vector<std::uint32_t> changed_;
  std::uint32_t time_ = 0;
  Flags inside_;
};

}  // namespace tetsculpt
