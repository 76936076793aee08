// N. Amenta, S. Choi, R. K. Kolluri, "The power crust", Solid Modeling 2001, label poles so. Two
// poles of one vertex lie on opposite sides, as surely as the angle between them is straight; two
// nodes whose circumspheres overlap deeply lie on the same side, as surely as the cosine of the
// angle at which the spheres meet. A node's certainty is the larger of its evidence for inside and
// for outside; with both, their difference minus one, so that contradictions come last.
#include "sculpt/first_guess.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
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

/// Certainty in steps, of which the greatest is the most.
using Step = std::uint32_t;
constexpr Step kStepsPerOne = 1024;
constexpr Step kSteps = 2 * kStepsPerOne + 1;

/// Precondition: -1 <= certainty <= 1.
Step step_of(float certainty) { return static_cast<Step>((certainty + 1) * kStepsPerOne); }

/// A stack of nodes per step.
class StepQueue {
 public:
  struct Entry {
    Node node;
    Step step;
  };

  void push(Entry entry) {
    const auto at = static_cast<std::uint32_t>(links_.size());
    links_.push_back({entry.node, top_[entry.step]});
    top_[entry.step] = at + 1;
    const std::size_t word = entry.step / 64;
    filled_[word] |= std::uint64_t{1} << entry.step % 64;
    highest_ = std::max(highest_, word);
  }

  /// The last one pushed of those with the greatest step, taken out.
  std::optional<Entry> pop() {
    while (filled_[highest_] == 0) {
      if (highest_ == 0) return std::nullopt;
      --highest_;
    }
    const auto bit = static_cast<std::size_t>(std::bit_width(filled_[highest_]) - 1);
    const auto step = static_cast<Step>(64 * highest_ + bit);
    const Link link = links_[top_[step] - 1];
    top_[step] = link.below;
    if (link.below == 0) filled_[highest_] ^= std::uint64_t{1} << bit;
    return Entry{link.node, step};
  }

 private:
  /// What lies below is counted from 1; 0 is the bottom.
  struct Link {
    Node node;
    std::uint32_t below;
  };
  LargeArray<Link> links_;
  std::array<std::uint32_t, kSteps> top_{};
  std::array<std::uint64_t, kSteps / 64 + 1> filled_{};
  std::size_t highest_ = 0;  ///< no word above has a bit
};

class Propagation {
 public:
  Propagation(const LabelGraph& graph, std::span<const PolePair> pairs)
      : graph_(graph),
        side_(graph.node_count(), Side::kUnknown),
        belief_(graph.node_count(), Belief{}) {
    list_oppositions(pairs);
  }

  LargeArray<Side> run() {
    side_[LabelGraph::kOutside] = Side::kOutside;
    spread(LabelGraph::kOutside);
    while (const std::optional<StepQueue::Entry> top = queue_.pop()) {
      const Belief& belief = belief_[top->node];
      if (side_[top->node] != Side::kUnknown || top->step != step_of(belief.certainty())) continue;
      side_[top->node] = belief.inside > belief.outside ? Side::kInside : Side::kOutside;
      spread(top->node);
    }
    return std::move(side_);
  }

 private:
  /// The strongest evidence for either side.
  struct Belief {
    float inside = 0;
    float outside = 0;

    float certainty() const {
      return inside > 0 && outside > 0 ? std::fabs(inside - outside) - 1
                                       : std::max(inside, outside);
    }
  };

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

  void support(Node x, bool inside, float strength) {
    Belief& belief = belief_[x];
    float& evidence = inside ? belief.inside : belief.outside;
    if (strength <= evidence) return;
    evidence = strength;
    queue_.push({x, step_of(belief.certainty())});
  }

  /// Tells a node's neighbours and opposite poles what its side means for them.
  void spread(Node x) {
    const bool inside = side_[x] == Side::kInside;
    for (std::uint32_t k = first_[x]; k < first_[x + 1]; ++k) {
      const auto [other, strength] = oppositions_[k];
      if (side_[other] == Side::kUnknown) support(other, !inside, strength);
    }
    for (const LabelGraph::Arc& arc : graph_.arcs_of(x)) {
      if (side_[arc.head] != Side::kUnknown) continue;
      const float cosine = arc.overlap;
      support(arc.head, inside == (cosine > 0), cosine > 0 ? cosine : -cosine * kWeakOpposition);
    }
  }

  const LabelGraph& graph_;
  LargeArray<Side> side_;
  LargeArray<Belief> belief_;
  StepQueue queue_;
  LargeArray<std::uint32_t> first_;  ///< per node, its first opposition
  LargeArray<Opposition> oppositions_;
};

}  // namespace

LargeArray<Side> first_guess(const LabelGraph& graph, std::span<const PolePair> pairs) {
  return Propagation(graph, pairs).run();
}

}  // namespace tetsculpt
