// A walk over surfaces, uphill and with a tabu list (F. Glover, "Tabu search", ORSA Journal on
// Computing 1, 1989): of all flips nearby that keep the topology it takes the one that leaves the
// fewest vertices hidden and brings most edges of the hidden vertex's link to the boundary, because
// a whole link triangle there is all that is needed. It does not go back for some steps. Random
// numbers are seeded by the vertex, so that the result is a function of the points.
#include "sculpt/flip_walk.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/split_mix.h"
#include "sculpt/exposure.h"

namespace tetsculpt {
namespace {

constexpr std::uint32_t kBarred = 5;  ///< steps before a flip may be undone, and up to as many more

class Walk {
 public:
  Walk(Boundary& boundary, const VertexStars& stars, VertexId v)
      : boundary_(boundary),
        complex_(boundary.complex()),
        star_(stars(v)),
        v_(v),
        hidden_goal_(boundary.hidden_count() - 1),
        random_state_(+v) {
    for (const TetId t : star_) {
      for (const VertexId u : complex_.vertices(t)) {
        if (u == kInfinite) continue;
        std::copy_if(stars(u).begin(), stars(u).end(), std::back_inserter(region_),
                     [&](TetId s) { return complex_.finite(s); });
      }
    }
    std::sort(region_.begin(), region_.end());
    region_.erase(std::unique(region_.begin(), region_.end()), region_.end());
    barred_until_.assign(region_.size(), 0);
  }

  bool run(std::size_t steps) {
    for (std::uint32_t step = 1; step <= steps; ++step) {
      const std::size_t k = best_flip(step);
      if (k == region_.size()) continue;
      boundary_.flip(region_[k]);
      path_.push_back(region_[k]);
      barred_until_[k] = step + kBarred +
                         static_cast<std::uint32_t>(split_mix_next(random_state_) % (kBarred + 1));
      if (boundary_.hidden_count() <= hidden_goal_ && boundary_.on_boundary(v_)) return true;
    }
    std::for_each(path_.rbegin(), path_.rend(), [&](TetId t) { boundary_.flip(t); });
    return false;
  }

 private:
  /// Index in the region; its size if there is no flip.
  std::size_t best_flip(std::uint32_t step) {
    std::size_t best = region_.size();
    long highest = 0;
    std::uint64_t ties = 0;
    for (std::size_t k = 0; k < region_.size(); ++k) {
      if (barred_until_[k] > step || !keeps_topology(region_[k])) continue;
      boundary_.flip(region_[k]);
      const long score = score_now();
      boundary_.flip(region_[k]);
      if (best != region_.size() && score < highest) continue;
      ties = best != region_.size() && score == highest ? ties + 1 : 1;
      if (ties > 1 && split_mix_next(random_state_) % ties != 0) continue;
      best = k;
      highest = score;
    }
    return best;
  }

  /// The basic rules; or three boundary faces around a vertex that has no others.
  bool keeps_topology(TetId t) const {
    const Exposure e = exposure(boundary_, t);
    if (e.faces != 3) return e.removable;
    for (std::size_t i = 0; i < 4; ++i) {
      if (!e.on_boundary(i)) return boundary_.triangles_at(complex_.vertices(t)[i]) == 3;
    }
    return false;
  }

  /// How near the vertex is to coming out.
  long score_now() const {
    static constexpr std::array<long, 4> kPerFacet{0, 1, 4, 16};  // by edges on the boundary
    constexpr long kPerHidden = 1000;
    long score = -kPerHidden * static_cast<long>(boundary_.hidden_count());
    for (const TetId t : star_) {
      if (!complex_.finite(t)) continue;
      const auto& c = kFacetCorners[static_cast<std::size_t>(corner_of(complex_.vertices(t), v_))];
      std::size_t edges = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        edges += boundary_.on_boundary(complex_.edge(t, kEdgeOfCorners[c[i]][c[(i + 1) % 3]]));
      }
      score += kPerFacet[edges];
    }
    return score;
  }

  Boundary& boundary_;
  const TetComplex& complex_;
  std::span<const TetId> star_;
  VertexId v_;
  std::size_t hidden_goal_;
  std::uint64_t random_state_;
  std::vector<TetId> region_;
  std::vector<std::uint32_t> barred_until_;  ///< per tetrahedron of the region, a step
  std::vector<TetId> path_;
};

}  // namespace

bool expose_by_walk(Boundary& boundary, const VertexStars& stars, VertexId v, std::size_t steps) {
  return Walk(boundary, stars, v).run(steps);
}

}  // namespace tetsculpt
