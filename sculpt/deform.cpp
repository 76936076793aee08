#include "sculpt/deform.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

#include "sculpt/priority.h"

namespace tetsculpt {
namespace {

/// A search for one vertex gives up after so many flips.
constexpr int kMostFlips = 100'000;
constexpr int kDeepest = 3;

bool flippable(const Boundary& boundary, TetId t) {
  return boundary.complex().finite(t) && exposure(boundary, t).removable;
}

/// Looks for a short sequence of flips that brings one hidden vertex to the surface.
class ExposureSearch {
 public:
  ExposureSearch(Boundary& boundary, const VertexStars& stars, const Circumspheres& spheres,
                 VertexId v)
      : boundary_(boundary), spheres_(spheres), v_(v) {
    const TetComplex& complex = boundary.complex();
    for (const TetId t : stars(v)) {
      for (const VertexId u : complex.vertices(t)) {
        if (u == kInfinite) continue;
        for (const TetId s : stars(u)) {
          if (complex.finite(s)) region_.push_back(s);
        }
      }
    }
    std::sort(region_.begin(), region_.end());
    region_.erase(std::unique(region_.begin(), region_.end()), region_.end());
  }

  /// Applies the shortest sequence, of several the one with the least sum of radii; false if none.
  bool run() {
    for (int depth = 1; depth <= kDeepest && best_.empty(); ++depth) descend(depth, 0);
    for (const TetId t : best_) boundary_.flip(t);
    return !best_.empty();
  }

 private:
  void descend(int depth, double cost_so_far) {
    for (const TetId t : region_) {
      if (flips_ >= kMostFlips) return;
      if (!flippable(boundary_, t) || (depth == 1 && !holds_vertex(t))) continue;
      if (!path_.empty() && path_.back() == t) continue;
      const double total = cost_so_far + spheres_.radius(t);
      path_.push_back(t);
      boundary_.flip(t);
      ++flips_;
      if (boundary_.on_boundary(v_)) {
        if (total < best_cost_) best_ = path_, best_cost_ = total;
      } else if (depth > 1) {
        descend(depth - 1, total);
      }
      boundary_.flip(t);
      path_.pop_back();
    }
  }

  bool holds_vertex(TetId t) const {
    const auto& c = boundary_.complex().vertices(t);
    return std::find(c.begin(), c.end(), v_) != c.end();
  }

  Boundary& boundary_;
  const Circumspheres& spheres_;
  VertexId v_;
  std::vector<TetId> region_;
  std::vector<TetId> path_;
  std::vector<TetId> best_;
  double best_cost_ = HUGE_VAL;
  int flips_ = 0;
};

}  // namespace

void deform_towards(Boundary& boundary, const Circumspheres& spheres, const Flags& wanted,
                    FlipOrder order) {
  struct Entry {
    double key;
    TetId tet;
  };
  const TetComplex& complex = boundary.complex();
  const double sign = order == FlipOrder::kSmallestFirst ? 1 : -1;
  const auto later = [&](const Entry& a, const Entry& b) {
    return a.key != b.key ? a.key > b.key : corners_less(complex, b.tet, a.tet);
  };
  std::priority_queue<Entry, std::vector<Entry>, decltype(later)> queue(later);
  const auto push = [&](TetId t) {
    if (boundary.solid()[+t] != wanted[+t] && flippable(boundary, t)) {
      queue.push({sign * spheres.radius(t), t});
    }
  };
  for (std::uint32_t t = 0; t < complex.finite_tet_count(); ++t) push(TetId{t});
  while (!queue.empty()) {
    const Entry entry = queue.top();
    queue.pop();
    if (boundary.solid()[+entry.tet] == wanted[+entry.tet]) continue;
    const Exposure e = exposure(boundary, entry.tet);
    if (!e.removable) continue;
    boundary.flip(entry.tet);
    for (int i = 0; i < 4; ++i) push(complex.neighbor(entry.tet, i));
    // The edge between two boundary faces leaves the boundary, which may free others around it.
    if (e.faces == 2) {
      complex.turn(complex.edge(entry.tet, 5 - e.opposite_edge), [&](Facet f, VertexId) {
        push(f.tet);
        return true;
      });
    }
  }
}

void expose_hidden(Boundary& boundary, const VertexStars& stars, const Circumspheres& spheres) {
  for (bool progress = true; progress && boundary.hidden_count() > 0;) {
    progress = false;
    for (const VertexId v : boundary.hidden_vertices()) {
      if (boundary.on_boundary(v)) continue;
      progress = ExposureSearch(boundary, stars, spheres, v).run() || progress;
    }
  }
}

}  // namespace tetsculpt
