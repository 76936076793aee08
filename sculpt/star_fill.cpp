#include "sculpt/star_fill.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sculpt/star_inspector.h"

namespace tetsculpt {

void fill_bad_stars(const TetComplex& complex, const VertexStars& stars, Flags& inside) {
  StarInspector inspector(complex, stars);
  std::vector<VertexId> queue;
  for (std::uint32_t v = 0; v < complex.vertex_count(); ++v) queue.push_back(VertexId{v});
  // Labels only change to inside, so this ends.
  for (std::size_t k = 0; k < queue.size(); ++k) {
    if (inspector.parts(queue[k], inside).excess() == 0) continue;
    for (const TetId t : stars(queue[k])) {
      if (!complex.finite(t) || inside[+t]) continue;
      inside[+t] = 1;
      for (const VertexId v : complex.vertices(t)) queue.push_back(v);
    }
  }
}

}  // namespace tetsculpt
