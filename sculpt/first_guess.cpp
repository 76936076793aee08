// N. Amenta, S. Choi, R. K. Kolluri, "The power crust", Solid Modeling 2001, label poles so. Two
// poles of one vertex lie on opposite sides, as surely as the angle between them is straight; two
// nodes whose circumspheres overlap deeply lie on the same side, as surely as the cosine of the
// angle at which the spheres meet. A node's certainty is the larger of its evidence for inside and
// for outside; with both, their difference minus one, so that contradictions come last.
#include "sculpt/first_guess.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace tetsculpt {
namespace {

using Node = LabelGraph::Node;

/// Of an overlap with negative cosine, as evidence for opposite sides.
constexpr float kWeakOpposition = 0.5f;

/// Evidence between two nodes that are poles of one vertex.
struct Opposition {
  Node other;
  float strength;
};

class Propagation {
 public:
  Propagation(const LabelGraph& graph, std::span<const float> overlap,
              std::span<const PolePair> pairs)
      : graph_(graph),
        overlap_(overlap),
        side_(graph.node_count(), Side::kUnknown),
        for_inside_(graph.node_count(), 0),
        for_outside_(graph.node_count(), 0) {
    list_oppositions(pairs);
  }

  LargeArray<Side> run() {
    side_[LabelGraph::kOutside] = Side::kOutside;
    spread(LabelGraph::kOutside);
    while (!queue_.empty()) {
      const Entry top = queue_.top();
      queue_.pop();
      const Node x = ~static_cast<Node>(top);
      if (side_[x] != Side::kUnknown || top != entry(x)) continue;
      side_[x] = for_inside_[x] > for_outside_[x] ? Side::kInside : Side::kOutside;
      spread(x);
    }
    return std::move(side_);
  }

 private:
  /// The larger, the sooner: a node's certainty and, among equals, the lower node.
  using Entry = std::uint64_t;
  Entry entry(Node x) const {
    const auto bits = std::bit_cast<std::uint32_t>(certainty(x) + 0.0f);  // no negative zero
    // In the order of their values: the bits of a float, or of a negative one their complement.
    const std::uint32_t ordered = bits >> 31 != 0 ? ~bits : bits | 0x80000000u;
    return Entry{ordered} << 32 | static_cast<Node>(~x);
  }

  void list_oppositions(std::span<const PolePair> pairs) {
    first_.assign(graph_.node_count() + 1, 0);
    const auto for_each_pair = [&](auto&& visit) {
      for (const PolePair& pair : pairs) {
        if (pair.strength <= 0) continue;
        const Node a = graph_.node_of_tet[+pair.first];
        const Node b = graph_.node_of_tet[+pair.second];
        if (a != b) visit(a, b, static_cast<float>(pair.strength));
      }
    };
    for_each_pair([&](Node a, Node b, float) { ++first_[a + 1], ++first_[b + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    oppositions_.resize(first_.back());
    LargeArray<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for_each_pair([&](Node a, Node b, float strength) {
      oppositions_[next[a]++] = {b, strength};
      oppositions_[next[b]++] = {a, strength};
    });
  }

  float certainty(Node x) const {
    const float in = for_inside_[x];
    const float out = for_outside_[x];
    return in > 0 && out > 0 ? std::fabs(in - out) - 1 : std::max(in, out);
  }

  void support(Node x, bool inside, float strength) {
    if (side_[x] != Side::kUnknown) return;
    float& evidence = inside ? for_inside_[x] : for_outside_[x];
    if (strength <= evidence) return;
    evidence = strength;
    queue_.push(entry(x));
  }

  /// Tells a node's neighbours and opposite poles what its side means for them.
  void spread(Node x) {
    const bool inside = side_[x] == Side::kInside;
    for (std::uint32_t k = first_[x]; k < first_[x + 1]; ++k) {
      support(oppositions_[k].other, !inside, oppositions_[k].strength);
    }
    for (const LabelGraph::Arc& arc : graph_.arcs_of(x)) {
      const float cosine = overlap_[+arc.triangle];
      support(arc.head, inside == (cosine > 0), cosine > 0 ? cosine : -cosine * kWeakOpposition);
    }
  }

  const LabelGraph& graph_;
  std::span<const float> overlap_;
  LargeArray<Side> side_;
  LargeArray<float> for_inside_;
  LargeArray<float> for_outside_;
  std::priority_queue<Entry> queue_;
  LargeArray<std::uint32_t> first_;  ///< per node, its first opposition
  LargeArray<Opposition> oppositions_;
};

}  // namespace

LargeArray<Side> first_guess(const LabelGraph& graph, std::span<const float> overlap,
                             std::span<const PolePair> pairs) {
  return Propagation(graph, overlap, pairs).run();
}

}  // namespace tetsculpt
