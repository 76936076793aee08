#include "sculpt/star_repair.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "sculpt/energy.h"
#include "sculpt/star_inspector.h"

namespace tetsculpt {
namespace {

/// The parts of one star: sets of tetrahedra on one side, connected through facets at the vertex.
struct Part {
  bool inside;
  bool infinite = false;  ///< holds an infinite tetrahedron
  std::vector<TetId> tets;
};

std::vector<Part> star_parts(const TetComplex& complex, std::span<const TetId> star, VertexId v,
                             const Flags& inside) {
  std::vector<Part> parts;
  std::vector<bool> seen(star.size(), false);
  const auto place = [&](TetId t) {  // stars are in order of id
    return static_cast<std::size_t>(std::lower_bound(star.begin(), star.end(), t) - star.begin());
  };
  for (std::size_t first = 0; first < star.size(); ++first) {
    if (seen[first]) continue;
    Part part{inside[+star[first]] != 0, false, {star[first]}};
    seen[first] = true;
    for (std::size_t k = 0; k < part.tets.size(); ++k) {
      const TetId t = part.tets[k];
      part.infinite = part.infinite || !complex.finite(t);
      for (int i = 0; i < 4; ++i) {
        if (complex.vertices(t)[static_cast<std::size_t>(i)] == v) continue;
        const TetId u = complex.neighbor(t, i);
        if ((inside[+u] != 0) != part.inside || seen[place(u)]) continue;
        seen[place(u)] = true;
        part.tets.push_back(u);
      }
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

class Repair {
 public:
  Repair(const TetComplex& complex, const VertexStars& stars, const Evidence& evidence,
         Flags& inside)
      : complex_(complex),
        stars_(stars),
        inspector_(complex, stars),
        evidence_(evidence),
        inside_(inside) {}

  void run() {
    for (std::uint32_t v = 0; v < complex_.vertex_count(); ++v) {
      if (excess_at(VertexId{v}) > 0) queue_.push_back(VertexId{v});
    }
    // Every accepted move lowers the total excess, so this ends; a move looks again at what it
    // touched.
    for (std::size_t k = 0; k < queue_.size(); ++k) improve(queue_[k]);
    fill();
  }

 private:
  using Move = std::vector<TetId>;

  int excess_at(VertexId v) { return inspector_.parts(v, inside_).excess(); }

  void flip(const Move& move) {
    for (const TetId t : move) inside_[+t] ^= 1;
  }

  std::vector<VertexId> vertices(const Move& move) const {
    std::vector<VertexId> touched;
    for (const TetId t : move) {
      for (const VertexId v : complex_.vertices(t)) touched.push_back(v);
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    return touched;
  }

  /// Whole parts of a side with several, and single tetrahedra of the star.
  std::vector<Move> moves(VertexId v) const {
    std::vector<Move> moves;
    std::vector<Part> parts = star_parts(complex_, stars_(v), v, inside_);
    for (Part& part : parts) {
      if (!part.infinite && part.tets.size() > 1) moves.push_back(std::move(part.tets));
    }
    for (const TetId t : stars_(v)) {
      if (complex_.finite(t)) moves.push_back({t});
    }
    return moves;
  }

  /// Change of the total excess and of the energy by a move.
  std::pair<int, double> effect(const Move& move) {
    const std::vector<VertexId> touched = vertices(move);
    int change = 0;
    double cost = 0;
    for (const VertexId v : touched) change -= excess_at(v);
    for (const TetId t : move) {
      cost += flip_cost(complex_, evidence_, inside_, t);
      inside_[+t] ^= 1;
    }
    for (const VertexId v : touched) change += excess_at(v);
    flip(move);
    return {change, cost};
  }

  void improve(VertexId v) {
    if (excess_at(v) == 0) return;
    const std::vector<Move> candidates = moves(v);
    std::pair<int, double> best{0, 0};
    const Move* chosen = nullptr;
    for (const Move& move : candidates) {
      const auto effect_of_move = effect(move);
      if (effect_of_move.first < 0 && effect_of_move < best) {
        best = effect_of_move;
        chosen = &move;
      }
    }
    if (!chosen) return;
    flip(*chosen);
    for (const VertexId u : vertices(*chosen)) {
      if (excess_at(u) > 0) queue_.push_back(u);
    }
  }

  /// Fills the stars that are still bad. Labels only change to inside, so this ends.
  void fill() {
    for (std::size_t k = 0; k < queue_.size(); ++k) {
      if (excess_at(queue_[k]) == 0) continue;
      Move move;
      for (const TetId t : stars_(queue_[k])) {
        if (complex_.finite(t) && !inside_[+t]) move.push_back(t);
      }
      flip(move);
      for (const VertexId u : vertices(move)) queue_.push_back(u);
    }
  }

  const TetComplex& complex_;
  const VertexStars& stars_;
  StarInspector inspector_;
  const Evidence& evidence_;
  Flags& inside_;
  std::vector<VertexId> queue_;  ///< every bad vertex is in it
};

}  // namespace

void repair_stars(const TetComplex& complex, const VertexStars& stars, const Evidence& evidence,
                  Flags& inside) {
  Repair(complex, stars, evidence, inside).run();
}

}  // namespace tetsculpt
