// Every change of a tetrahedron's side puts each of its facets on the surface or takes it off. A
// replay of the changes notes for each triangle when it last came, and lists it when it goes.
#include "sculpt/record.h"

#include <array>
#include <cstddef>

#include "sculpt/boundary.h"

namespace tetsculpt {
namespace {

/// The tetrahedra in which two labelings differ, breadth first: those before which one is that has
/// their new side already, then their neighbours of the same side, and so on; at the end those that
/// cannot be reached so, each followed by its own.
std::vector<TetId> changes(const TetComplex& complex, const Flags& before, const Flags& after) {
  std::vector<TetId> order;
  Flags waiting(complex.tet_count(), 0);
  for (std::size_t t = 0; t < waiting.size(); ++t) waiting[t] = before[t] != after[t];
  const auto take = [&](TetId t) {
    waiting[+t] = 0;
    order.push_back(t);
  };
  const auto next_to_its_side = [&](TetId t) {
    for (int i = 0; i < 4; ++i) {
      const TetId u = complex.neighbor(t, i);
      if (before[+u] == after[+u] && after[+u] == after[+t]) return true;
    }
    return false;
  };
  std::size_t followed = 0;
  const auto follow = [&] {
    for (; followed < order.size(); ++followed) {
      const TetId t = order[followed];
      for (int i = 0; i < 4; ++i) {
        const TetId u = complex.neighbor(t, i);
        if (waiting[+u] && after[+u] == after[+t]) take(u);
      }
    }
  };
  for (std::uint32_t t = 0; t < complex.finite_tet_count(); ++t) {
    if (waiting[t] && next_to_its_side(TetId{t})) take(TetId{t});
  }
  follow();
  for (std::uint32_t t = 0; t < complex.finite_tet_count(); ++t) {
    if (!waiting[t]) continue;
    take(TetId{t});
    follow();
  }
  return order;
}

void append(SculptingSteps& steps, std::span<const TetId> tets) {
  for (const TetId t : tets) {
    steps.tets.push_back(t);
    steps.step.push_back(static_cast<std::uint32_t>(steps.step.size()) + 1);
  }
}

/// Removals a step each, but three in one where a pseudo-prism starts.
SculptingSteps removals(const Sculpture& sculpture) {
  SculptingSteps steps{sculpture.removed, {}};
  steps.step.reserve(steps.tets.size());
  std::uint32_t step = 0;
  std::size_t prism = 0;
  while (steps.step.size() < steps.tets.size()) {
    const bool hole = prism < sculpture.holes.size() && sculpture.holes[prism] == steps.step.size();
    steps.step.insert(steps.step.end(), hole ? 3 : 1, ++step);
    prism += hole ? 1 : 0;
  }
  return steps;
}

/// Replays changes of side.
class Recorder {
 public:
  explicit Recorder(const TetComplex& complex)
      : complex_(complex), inside_(all_finite(complex)), since_(complex.triangle_count(), 0) {}

  void flip(TetId t, std::uint32_t step) {
    for (int i = 0; i < 4; ++i) {
      if (on_surface({t, i})) {
        leave({t, i}, step);
      } else {
        since_[+complex_.triangle(t, i)] = step;
      }
    }
    inside_[+t] ^= 1;
  }

  SculptingRecord finish(std::uint32_t step_count) {
    for (std::uint32_t t = 0; t < complex_.finite_tet_count(); ++t) {
      if (!inside_[t]) continue;
      for (int i = 0; i < 4; ++i) {
        if (on_surface({TetId{t}, i})) leave({TetId{t}, i}, SculptingRecord::kNever);
      }
    }
    out_.step_count = step_count;
    return std::move(out_);
  }

 private:
  bool on_surface(Facet f) const {
    return inside_[+f.tet] != inside_[+complex_.neighbor(f.tet, f.corner)];
  }
  void leave(Facet f, std::uint32_t step) {
    const std::uint32_t born = since_[+complex_.triangle(f.tet, f.corner)];
    if (born == step) return;
    if (!inside_[+f.tet]) f = complex_.across(f.tet, f.corner);
    const auto& v = complex_.vertices(f.tet);
    const auto& c = kFacetCorners[static_cast<std::size_t>(f.corner)];
    const auto index = [&](std::size_t k) { return static_cast<std::uint32_t>(+v[c[k]]); };
    out_.triangles.push_back({index(0), index(1), index(2)});
    out_.born.push_back(born);
    out_.died.push_back(step);
  }

  const TetComplex& complex_;
  Flags inside_;
  LargeArray<std::uint32_t> since_;  ///< per triangle on the surface, the step that put it there
  SculptingRecord out_;
};

}  // namespace

SculptingSteps sculpting_steps(const TetComplex& complex, const Sculpture& sculpture) {
  if (!sculpture.removed.empty()) return removals(sculpture);
  const Flags& labels = sculpture.labels.empty() ? sculpture.solid : sculpture.labels;
  SculptingSteps steps;
  append(steps, changes(complex, all_finite(complex), labels));
  append(steps, changes(complex, labels, sculpture.solid));
  return steps;
}

SculptingRecord sculpting_record(const TetComplex& complex, const SculptingSteps& steps) {
  Recorder recorder(complex);
  for (std::size_t i = 0; i < steps.tets.size(); ++i) recorder.flip(steps.tets[i], steps.step[i]);
  return recorder.finish(steps.step.empty() ? 0 : steps.step.back());
}

}  // namespace tetsculpt
