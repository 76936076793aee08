#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/large_array.h"
#include "kernel/vertex_stars.h"
#include "sculpt/boundary.h"
#include "sculpt/evidence.h"
#include "sculpt/star_inspector.h"

/// Local search for flips that make stars good and bring hidden vertices to the surface.
namespace tetsculpt {

/// Flips tetrahedra, whether the basic rules allow it or not, until all stars that it touched are
/// good again: the topology of the surface may change. Keeps references to its arguments; nobody
/// else may change the boundary meanwhile.
class StarSearch {
 public:
  StarSearch(Boundary& boundary, const VertexStars& stars, const Evidence& evidence);

  /// Makes all bad stars good by at most so many flips. Vertices that are hidden may stay so, and
  /// no others are. On failure, false, nothing has changed.
  bool mend_bad(std::size_t flips);
  /// Brings a hidden vertex to the surface by at most so many flips: all stars are good as before,
  /// and no other vertex is hidden that was not. On failure, false, nothing has changed.
  bool expose(VertexId v, std::size_t flips);

 private:
  int fault_of(VertexId v);
  void refresh(VertexId v);
  void flip(TetId t);
  int change_by(TetId t);
  bool search(std::size_t flips, std::uint64_t seed);
  TetId best_flip(VertexId v, std::int64_t least_total);
  TetId random_flip(VertexId v);
  void undo_needless();
  void hold_exposed();

  Boundary& boundary_;
  const VertexStars& stars_;
  const Evidence& evidence_;
  StarInspector inspector_;
  LargeArray<std::uint8_t> fault_;     ///< per vertex; a hidden one that may stay so has none
  LargeArray<std::uint8_t> may_hide_;  ///< per vertex
  LargeArray<std::uint32_t> place_;    ///< per vertex, in faulty_
  std::vector<VertexId> faulty_;
  std::int64_t faults_ = 0;                 ///< sum of fault_
  LargeArray<std::uint32_t> barred_until_;  ///< per tetrahedron, a number of flips
  std::vector<TetId> path_;                 ///< the search's flips so far
  std::uint64_t random_state_ = 0;
};

}  // namespace tetsculpt
