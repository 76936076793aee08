#pragma once

#include <bit>
#include <cstddef>
#include <vector>

/// The order in which points enter the hull.
namespace tetsculpt {

/// Vertices of one round: every step-th, less those of the rounds before.
struct InsertionRound {
  /// A round is fifteen times as large as all before it.
  static constexpr std::size_t kRatio = 16;
  static_assert(std::has_single_bit(kRatio));

  std::size_t vertex_count;  ///< of the set
  std::size_t step;          ///< a power of kRatio
  bool first;

  std::size_t size() const;
  /// Calls visit(v) on each vertex of [begin, end), a part of the set, that is in the round.
  template <class Visit>
  void each(std::size_t begin, std::size_t end, Visit&& visit) const {
    for (std::size_t v = (begin + step - 1) / step * step; v < end; v += step) {
      if (first || (v & (kRatio * step - 1)) != 0) visit(v);
    }
  }
};

/// Every 16^k-th vertex, for k down to 0: within a round by id, which is along a Hilbert curve.
std::vector<InsertionRound> insertion_rounds(std::size_t vertex_count);

}  // namespace tetsculpt
