#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/point.h"
#include "kernel/tet_complex.h"
#include "sculpt/boundary.h"

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
  Priority(Criterion criterion, std::span<const Point3> points, const TetComplex& complex);

  /// Key of a tetrahedron with these boundary faces. Precondition: it has one or two.
  double key(TetId t, const Exposure& exposure) const;
  /// Rank of the tetrahedron's longest edge on its boundary faces (longest-edge criteria only).
  std::uint32_t longest_edge_rank(TetId t, const Exposure& exposure) const;

 private:
  double area_change(TetId t, const Exposure& exposure) const;
  double gamma(TetId t, const Exposure& exposure) const;

  Criterion criterion_;
  std::span<const Point3> points_;
  const TetComplex* complex_;
  std::vector<std::uint32_t> rank_of_edge_;
};

/// True if a's corners come before b's in lexicographic order: breaks ties between equal keys.
bool corners_less(const TetComplex& complex, TetId a, TetId b);

}  // namespace tetsculpt
