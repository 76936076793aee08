#include "kernel/vertex_stars.h"

#include <numeric>

#include "kernel/large_array.h"

namespace tetsculpt {

VertexStars::VertexStars(const TetComplex& complex) : first_(complex.vertex_count() + 1, 0) {
  const auto for_each_corner = [&](auto&& visit) {
    for (std::uint32_t t = 0; t < complex.tet_count(); ++t) {
      for (const VertexId v : complex.vertices(TetId{t})) {
        if (v != kInfinite) visit(v, TetId{t});
      }
    }
  };
  for_each_corner([&](VertexId v, TetId) { ++first_[+v + 1]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  tets_.resize(first_.back());
  LargeArray<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for_each_corner([&](VertexId v, TetId t) { tets_[next[+v]++] = t; });
}

}  // namespace tetsculpt
