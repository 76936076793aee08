#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/ids.h"
#include "kernel/large_array.h"
#include "kernel/tet_complex.h"

/// The tetrahedra at each vertex.
namespace tetsculpt {

/// Lists of the tetrahedra, finite and infinite, at each vertex, in order of id.
class VertexStars {
 public:
  /// Cost: linear; one word per corner.
  explicit VertexStars(const TetComplex& complex);

  std::span<const TetId> operator()(VertexId v) const {
    return std::span(tets_).subspan(first_[+v], first_[+v + 1] - first_[+v]);
  }

 private:
  LargeArray<std::uint32_t> first_;
  LargeArray<TetId> tets_;
};

}  // namespace tetsculpt
