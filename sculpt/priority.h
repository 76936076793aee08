#pragma once

#include <array>
#include <span>

#include "kernel/point.h"
#include "sculpt/exposure.h"
#include "sculpt/manifold_solid.h"

/// In which order removable tetrahedra go: the four criteria of the paper's Figure 6.
namespace tetsculpt {

enum class Criterion {
  kMinimalArea,  ///< least change of surface area first [Boissonnat 1984]
  kGamma,        ///< smallest gamma-indicator first [Veltkamp 1994]
  kLongestEdge,  ///< longest boundary edge first, unconstrained
  kConstrained,  ///< longest boundary edge first, held back by EMST and EGH: the paper's own
};

/// Are keys ranks of edges, negative?
constexpr bool is_by_rank(Criterion criterion) {
  return criterion == Criterion::kLongestEdge || criterion == Criterion::kConstrained;
}

/// Gives tetrahedra their place in the heap: the smallest key goes first. Keys depend on nothing
/// but the points: the longest edge is compared exactly, by its rank in kernel/edge_order; areas
/// and gamma-indicators are doubles computed from vertices in lexicographic order.
class Priority {
 public:
  /// Keeps references to the solid and the points, which must outlive it.
  Priority(Criterion criterion, std::span<const Point3> points, const ManifoldSolid& solid)
      : criterion_(criterion), points_(points), solid_(&solid) {}

  /// Key of a tetrahedron with these boundary faces. Precondition: it has one or two.
  double key(TetId t, const Exposure& exposure) const;

 private:
  double area_change(TetId t, const Exposure& exposure) const;
  double gamma(TetId t, const Exposure& exposure) const;

  Criterion criterion_;
  std::span<const Point3> points_;
  const ManifoldSolid* solid_;
};

/// Are a's corners, as a complex has them, before b's in lexicographic order? Breaks ties between
/// equal keys.
bool corners_less(const std::array<VertexId, 4>& a, const std::array<VertexId, 4>& b);

}  // namespace tetsculpt
