#include "sculpt/star_inspector.h"

namespace tetsculpt {

StarParts StarInspector::parts(VertexId v, const Flags& inside) {
  StarParts count;
  ++search_;
  for (const TetId first : stars_(v)) {
    if (seen_[+first] == search_) continue;
    const std::uint8_t side = inside[+first];
    ++(side ? count.inside : count.outside);
    seen_[+first] = search_;
    stack_.assign(1, first);
    while (!stack_.empty()) {
      const TetId t = stack_.back();
      stack_.pop_back();
      for (int i = 0; i < 4; ++i) {
        if (complex_.vertices(t)[static_cast<std::size_t>(i)] == v) continue;
        const TetId u = complex_.neighbor(t, i);
        if (seen_[+u] == search_ || inside[+u] != side) continue;
        seen_[+u] = search_;
        stack_.push_back(u);
      }
    }
  }
  return count;
}

}  // namespace tetsculpt
