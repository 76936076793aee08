// Where a point goes in: walks over the hull that grows, to a facet that the point sees.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "kernel/hull_inserter.h"
#include "kernel/hull_lanes.h"
#include "kernel/predicates.h"

namespace tetsculpt::hull {

/// A facet that q sees, in the range or next to one in it; kNone if none was found: on the way from
/// where the last point was, or else from sites before q on the curve.
FacetIndex Inserter::locate(Site q) {
  FacetIndex found = last_ == kNone ? kNone : walk(q, last_);
  if (found != kNone || own_.all()) return found;
  mark_free();  // what is known may be gone
  int tries = 3;
  const Site group = q / kGroup;
  const Site end = group - std::min(group, kBack);
  for (Site g = group + 1; found == kNone && tries > 0 && g-- > end;) {
    if (!own_.sites().contains(g * kGroup)) continue;
    if (known_[g] >= kBarred || !in_group(known_[g], g)) continue;
    found = walk(q, known_[g]);
    --tries;
  }
  return found;
}

/// From f to a facet that q sees. Walks to neighbours whose sphere has the smaller power of q,
/// which is the side of their common triangle's plane on which q lies; every step is a few
/// multiply-adds, and the walk may end as soon as the power is negative. Rounding can only end it
/// early. kNone where it would have to go on beyond the range.
FacetIndex Inserter::walk(Site q, FacetIndex f) const {
  if (facets_.infinite(f)) {
    if (facets_.on_sphere(q)) f = walk_on_hull(q, f);
    if (facets_.visible(f, q)) return f;
    f = facet_of(facets_.neighbors(f)[3]);
    if (!own(f)) return kNone;
  }
  const LiftedDifference point = facets_.lifted(points_[q]);
  if (by_four_) {
    const Nearer nearer = nearer_by_four(facets_, f, point, own_);
    if (nearer.seen) return nearer.facet;  // it may be infinite
    f = nearer.facet;
  }
  Facets::Height h = facets_.height(f, point);
  if (h.value > h.error) return f;
  double height = h.value;  // the negative power
  bool at_border = false;   // of the range
  for (bool moved = true; moved;) {
    moved = false;
    at_border = false;
    const std::array<Ridge, 4> neighbors = facets_.neighbors(f);
    for (const Ridge r : neighbors) {
      const FacetIndex g = facet_of(r);
      h = facets_.height(g, point);
      if (h.value > h.error) return g;
      if (h.value <= height || facets_.infinite(g)) continue;
      if (!own(g)) {
        at_border = true;
        continue;
      }
      f = g;
      height = h.value;
      moved = true;
    }
  }
  return at_border ? kNone : locate_exactly(q, f);
}

/// From one infinite facet to another that q sees or that is higher below it than its neighbours in
/// the range. Where all points are on a sphere that is nearer than inside, where all powers are
/// zero.
FacetIndex Inserter::walk_on_hull(Site q, FacetIndex f) const {
  const LiftedDifference point = facets_.lifted(points_[q]);
  const auto distance = [&](FacetIndex g) {
    const Facet& n = facets_[g];
    return facets_.height(g, point).value / std::sqrt(n.nx * n.nx + n.ny * n.ny + n.nz * n.nz);
  };
  double height = distance(f);
  for (bool moved = true; moved && height <= 0;) {
    moved = false;
    const std::array<Ridge, 4> neighbors = facets_.neighbors(f);
    for (std::size_t i = 0; i < 3; ++i) {
      const FacetIndex g = facet_of(neighbors[i]);
      const double other = distance(g);
      if (other <= height || !own(g)) continue;
      f = g;
      height = other;
      moved = true;
    }
  }
  return f;
}

/// Visibility walk by exact orientations: ends in the tetrahedron that holds q, or beyond the hull.
/// It ends because the power of q falls with every step.
FacetIndex Inserter::locate_exactly(Site q, FacetIndex from) const {
  FacetIndex f = from;
  std::uint32_t entered = 4;  // through the ridge opposite this corner, behind which q is not
  for (bool moved = true; moved;) {
    moved = false;
    for (std::uint32_t i = 0; i < 4; ++i) {
      if (i == entered) continue;
      auto p = facets_.corners(f);
      p[i] = q;
      if (orient3d(points_[p[0]], points_[p[1]], points_[p[2]], points_[p[3]]) != Sign::kNegative) {
        continue;
      }
      const Ridge next = facets_.neighbors(f)[i];
      f = facet_of(next);
      entered = corner_of(next);
      if (!own(f)) return kNone;
      if (facets_.infinite(f)) return f;
      moved = true;
      break;
    }
  }
  return f;
}

}  // namespace tetsculpt::hull
