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

/// What a search may not change.
enum class Keep { kTopology, kNothing };

/// Flips tetrahedra, whether the basic rules allow it or not, until all stars that it touched are
/// good again. Keeps references to its arguments; nobody else may change the boundary meanwhile.
class StarSearch {
 public:
  StarSearch(Boundary& boundary, const VertexStars& stars, const Evidence& evidence);

  /// How many flips a search may make.
  struct Limits {
    std::size_t flips = 0;
    Keep keep = Keep::kNothing;
  };
  /// Makes all bad stars good. Vertices that are hidden may stay so, and no others are. On failure,
  /// false, nothing has changed.
  bool mend_bad(const Limits& limits);
  /// Brings a hidden vertex to the surface: all stars are good as before, and no other vertex is
  /// hidden that was not. On failure, false, nothing has changed.
  bool expose(VertexId v, const Limits& limits);

 private:
  int fault_of(VertexId v);
  void refresh(VertexId v);
  void flip(TetId t);
  int change_by(TetId t);
  std::int64_t euler_error() const;
  bool search(const Limits& limits, std::uint64_t seed);
  VertexId next_vertex();
  TetId best_flip(VertexId v, std::int64_t least_total);
  TetId random_flip(VertexId v);
  void undo_needless();
  std::uint64_t random();

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
  bool keep_topology_ = false;
  std::int64_t euler_goal_ = 0;
  std::uint64_t random_state_ = 0;
};

}  // namespace tetsculpt
