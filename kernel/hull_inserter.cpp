// The four steps of Quickhull are in insert_farthest; where points come from and in which order is
// kernel/lifted_hull's business.
#include "kernel/hull_inserter.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "kernel/predicates.h"

namespace tetsculpt::hull {
namespace {

// Pairs of the horizon's corners are tabulated, for few of them in a table that fits in the nearest
// cache; above the larger size they are sorted.
constexpr std::size_t kSmallCone = 32;
constexpr std::size_t kLargeCone = 256;

}  // namespace

Inserter::Inserter(std::span<const Point3> points, Facets& facets, std::vector<FacetIndex> free,
                   bool by_four)
    : points_(points),
      facets_(facets),
      by_four_(by_four),
      free_(std::move(free)),
      number_of_(points.size() + 1, Number{0, 0}),
      half_ridge_(kLargeCone * kLargeCone) {}

Inserter Inserter::helper(SiteRange own) {
  for (const FacetIndex f : free_) facets_.corners(f)[0] = kNone;
  Inserter helper(points_, facets_, std::exchange(free_, {}), by_four_);
  helper.own_ = own;
  helper.stamp_ = stamp_;
  // Begin at the end of the range's stretch of the curve where the points will.
  helper.last_ = kNone;
  Site first = kNone;
  for (FacetIndex f = 0; f < facets_.size(); ++f) {
    if (facets_.corners(f)[0] == kNone) continue;
    const Site lowest = std::ranges::min(facets_.corners(f));
    if (lowest >= first || !helper.own(f)) continue;
    first = lowest;
    helper.last_ = f;
  }
  return helper;
}

void Inserter::take_over(const Inserter& helper) {
  free_.insert(free_.end(), helper.free_.begin(), helper.free_.end());
  stamp_ = std::max(stamp_, helper.stamp_);
  if (helper.last_ != kNone) last_ = helper.last_;
}

bool Inserter::own(FacetIndex f) const {
  return own_.all() ||
         std::ranges::all_of(facets_.corners(f), [&](Site s) { return own_.contains(s); });
}

void Inserter::insert(std::span<const Site> batch) {
  assert(batch.size() <= kBatch);
  batch_ = batch;
  for (Slot k = 0; k < batch.size(); ++k) {
    const FacetIndex f = locate(batch[k]);
    if (f == kNone) {
      conflicts_[k].facet = kNone;
      deferred_.push_back(batch[k]);
    } else {
      last_ = f;
      add_conflict(k, f);
    }
  }
  for (Slot k = 0; k < batch.size(); ++k) {
    while (conflicts_[k].facet != kNone) {
      const FacetIndex f = conflicts_[k].facet;
      if (insert_farthest(f)) continue;
      const Slot apex = pick_apex(f);
      conflicts_[apex].facet = kNone;
      deferred_.push_back(batch[apex]);
    }
  }
}

/// Inserts the farthest point of the facet's conflict set. If it can't, false, nothing has changed.
bool Inserter::insert_farthest(FacetIndex seen) {
  const Slot slot = pick_apex(seen);
  const Site apex = batch_[slot];
  if (!find_horizon(apex, seen)) return false;
  const std::size_t at_hand = free_.size() + visible_.size();
  if (at_hand < horizon_.size() && !facets_.append(horizon_.size() - at_hand, free_)) return false;
  collect_orphans(slot);
  make_cone(apex);
  reassign_conflicts();
  return true;
}

Inserter::Slot Inserter::pick_apex(FacetIndex f) const {
  Slot apex = kNone;
  for (Slot k = 0; k < batch_.size(); ++k) {
    if (conflicts_[k].facet != f) continue;
    if (apex == kNone || conflicts_[k].height > conflicts_[apex].height) apex = k;
  }
  return apex;
}

/// The apex takes the place of the corner opposite; a double exchange, which keeps the orientation,
/// puts it first.
inline Inserter::HorizonRidge Inserter::horizon_ridge(const CutRidge& ridge) const {
  static constexpr std::uint8_t kOthers[4][3] = {{1, 2, 3}, {0, 3, 2}, {3, 0, 1}, {2, 1, 0}};
  const auto& c = facets_.corners(facet_of(ridge.inner));
  const auto& others = kOthers[corner_of(ridge.inner)];
  return {{c[others[0]], c[others[1]], c[others[2]]}, ridge.outer};
}

/// Grows the visible region from a facet that the apex sees, in waves; what it is cut off by is the
/// horizon. False if the region leaves the range. Which neighbours are visible comes without order:
/// no branch depends on it.
bool Inserter::find_horizon(Site apex, FacetIndex seen) {
  stamp_ += 2;
  const std::uint32_t is_visible = stamp_;
  const std::uint32_t is_hidden = stamp_ + 1;
  visible_.room_for(1)[0] = seen;
  facets_.mark(seen) = is_visible;
  std::size_t visible_size = 1;
  std::size_t cut_size = 0;
  for (std::size_t begin = 0; begin < visible_size;) {
    const std::size_t end = visible_size;
    FacetIndex* const visible = visible_.room_for(5 * end + 1);
    Seen* const sees = sees_.room_for(end);
    CutRidge* const cut = cut_.room_for(cut_size + 4 * (end - begin) + 1);
    if (!see_wave(apex, {visible + begin, visible + end}, sees + begin)) return false;
    for (; begin < end; ++begin) {
      const FacetIndex f = visible[begin];
      const std::array<Ridge, 4> neighbors = facets_.neighbors(f);
      if (sees[begin].unclear != 0) [[unlikely]]
        decide(apex, f, sees[begin]);
      const std::uint32_t bits = sees[begin].neighbors;
      for (std::uint32_t i = 0; i < 4; ++i) {
        const FacetIndex g = facet_of(neighbors[i]);
        const std::uint32_t sees_it = bits >> i & 1;
        const std::uint32_t before = facets_.mark(g);
        const bool is_new = before < is_visible;
        const std::uint32_t now = is_new ? is_hidden - sees_it : before;
        facets_.mark(g) = now;
        visible[visible_size] = g;
        visible_size += is_new & sees_it;
        cut[cut_size] = {ridge(f, i), neighbors[i]};
        cut_size += now - is_visible;
      }
    }
  }
  visible_.hold(visible_size);
  horizon_.clear();
  horizon_.make_room(cut_size);
  for (std::size_t k = 0; k < cut_size; ++k) horizon_.push(horizon_ridge(cut_[k]));
  return true;
}

/// What the apex sees of the neighbours of some facets; false if one is not in the range.
bool Inserter::see_wave(Site apex, std::span<const FacetIndex> wave, Seen* sees) {
  if (!own_.all() && !std::ranges::all_of(wave, [&](FacetIndex f) { return own(f); })) return false;
  for (const FacetIndex f : wave) {
    for (const Ridge r : facets_.neighbors(f)) facets_.prefetch(facet_of(r));
  }
  if (by_four_) {
    see_neighbors_by_four(facets_, wave, points_[apex], sees);
  } else {
    see_neighbors(facets_, wave, points_[apex], stamp_, sees);
  }
  return true;
}

/// Settles which of a facet's neighbours the apex sees where that is not clear, nor known.
void Inserter::decide(Site apex, FacetIndex f, Seen& sees) const {
  for (unsigned i = 0; i < 4; ++i) {
    const FacetIndex g = facet_of(facets_.neighbors(f)[i]);
    if ((sees.unclear >> i & 1) == 0 || facets_[g].mark >= stamp_) continue;
    if (facets_.decide(g, apex))
      sees.neighbors = static_cast<std::uint8_t>(sees.neighbors | 1u << i);
  }
}

void Inserter::collect_orphans(Slot apex) {
  orphans_.clear();
  orphans_.make_room(batch_.size());
  conflicts_[apex].facet = kNone;
  for (Slot k = 0; k < batch_.size(); ++k) {
    const FacetIndex f = conflicts_[k].facet;
    if (f != kNone && facets_.mark(f) == stamp_) orphans_.push(k);
  }
}

/// The number of a corner of the horizon; a new one gets its spoke.
inline std::uint32_t Inserter::number_of(Site s, Site apex) {
  Number& n = number_of_[s == kAtInfinity ? points_.size() : s];
  if (n.stamp != stamp_) {
    n = {stamp_, static_cast<std::uint32_t>(spokes_.size())};
    spokes_.push(s == kAtInfinity ? Spoke{} : spoke(points_[s], points_[apex]));
  }
  return n.number;
}

/// A facet for the k-th of the cone: one of the visible ones, which are gone, as long as there are
/// any.
inline FacetIndex Inserter::take_facet(std::size_t k) {
  if (k < visible_.size()) return visible_[k];
  const FacetIndex f = free_.back();
  free_.pop_back();
  return f;
}

/// Replaces the visible facets by one facet per horizon ridge, each with the apex as first corner.
void Inserter::make_cone(Site apex) {
  cone_.clear();
  cone_.make_room(horizon_.size());
  spokes_.clear();
  spokes_.make_room(horizon_.size() / 2 + 2);  // by Euler's relation
  for (std::size_t k = 0; k < horizon_.size(); ++k) {
    auto [a, b, c] = horizon_[k].corners;
    const Ridge outer = horizon_[k].outer;
    // A cyclic exchange keeps the orientation: bring the site at infinity last.
    if (a == kAtInfinity) {
      a = b, b = c, c = kAtInfinity;
    } else if (b == kAtInfinity) {
      b = a, a = c, c = kAtInfinity;
    }
    const FacetIndex f = take_facet(k);
    facets_.corners(f) = {apex, a, b, c};
    facets_.neighbors(f)[0] = outer;
    facets_.neighbors(facet_of(outer))[corner_of(outer)] = ridge(f, 0);
    facets_.mark(f) = 0;
    cone_.push({f, {number_of(a, apex), number_of(b, apex), number_of(c, apex)}});
  }
  if (by_four_) {
    set_hyperplanes_by_four(facets_, cone_.held(), spokes_.held());
  } else {
    set_hyperplanes(facets_, cone_.held(), spokes_.held());
  }
  if (visible_.size() > horizon_.size()) {
    free_.insert(free_.end(), visible_.begin() + horizon_.size(), visible_.end());
  }
  if (spokes_.size() <= kSmallCone) {
    link_cone<kSmallCone>();
  } else if (spokes_.size() <= kLargeCone) {
    link_cone<kLargeCone>();
  } else {
    link_large_cone();
  }
  last_ = cone_[0].facet;
}

/// Each directed edge of the horizon belongs to one ridge, its reverse to the neighbour: a table by
/// pairs of numbers, in which every entry read was written just before.
template <std::size_t kStride>
void Inserter::link_cone() {
  Ridge* const half_ridge = half_ridge_.data();
  for (const auto& [f, numbers] : cone_) {
    const auto [a, b, c] = numbers;
    half_ridge[b * kStride + c] = ridge(f, 1);
    half_ridge[c * kStride + a] = ridge(f, 2);
    half_ridge[a * kStride + b] = ridge(f, 3);
  }
  for (const auto& [f, numbers] : cone_) {
    const auto [a, b, c] = numbers;
    auto& neighbors = facets_.neighbors(f);
    neighbors[1] = half_ridge[c * kStride + b];
    neighbors[2] = half_ridge[a * kStride + c];
    neighbors[3] = half_ridge[b * kStride + a];
  }
}

void Inserter::link_large_cone() {
  struct Half {
    std::uint64_t edge;  ///< unordered pair of numbers
    Ridge ridge;
  };
  std::vector<Half> halves;
  halves.reserve(3 * cone_.size());
  for (std::size_t k = 0; k < cone_.size(); ++k) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint64_t a = cone_[k].numbers[(i + 1) % 3];
      const std::uint64_t b = cone_[k].numbers[(i + 2) % 3];
      halves.push_back({std::min(a, b) << 32 | std::max(a, b), ridge(cone_[k].facet, i + 1)});
    }
  }
  std::sort(halves.begin(), halves.end(),
            [](const Half& a, const Half& b) { return a.edge < b.edge; });
  for (std::size_t h = 0; h < halves.size(); h += 2) {
    assert(halves[h].edge == halves[h + 1].edge);
    const Ridge a = halves[h].ridge;
    const Ridge b = halves[h + 1].ridge;
    facets_.neighbors(facet_of(a))[corner_of(a)] = b;
    facets_.neighbors(facet_of(b))[corner_of(b)] = a;
  }
}

/// Hands each orphan to a facet of the cone that it sees; there is one, because an orphan saw a
/// facet that is gone and still lies outside the hull.
void Inserter::reassign_conflicts() {
  for (const Slot k : orphans_) {
    const Site q = batch_[k];
    const Point3 point = points_[q];
    const auto clearly_seen = [&](const ConeFacet& c) {
      const Facets::Height h = facets_.height(c.facet, point);
      return h.value > h.error;
    };
    auto* c = std::find_if(cone_.begin(), cone_.end(), clearly_seen);
    if (c == cone_.end()) {
      const auto seen = [&](const ConeFacet& g) { return facets_.visible(g.facet, q); };
      c = std::find_if(cone_.begin(), cone_.end(), seen);
    }
    assert(c != cone_.end());
    add_conflict(k, c->facet);
  }
}

void Inserter::add_conflict(Slot k, FacetIndex f) {
  conflicts_[k] = {f, facets_.height(f, points_[batch_[k]]).value};
}

/// A facet that q sees. Walks to neighbours whose sphere has the smaller power of q, which is the
/// side of their common triangle's plane on which q lies; every step is a few multiply-adds, and
/// the walk may end as soon as the power is negative. Rounding can only end it early. kNone where
/// the walk leaves the range.
FacetIndex Inserter::locate(Site q) const {
  FacetIndex f = last_;
  if (f == kNone) return kNone;
  if (facets_.infinite(f)) {
    if (facets_.visible(f, q)) return f;
    f = facet_of(facets_.neighbors(f)[3]);
    if (!own(f)) return kNone;
  }
  const Point3 point = points_[q];
  Facets::Height h = facets_.height(f, point);
  if (h.value > h.error) return f;
  double height = h.value;  // the negative power
  bool at_border = false;   // of the range
  for (bool moved = true; moved;) {
    moved = false;
    at_border = false;
    const std::array<Ridge, 4> neighbors = facets_.neighbors(f);
    const NeighborHeights heights = by_four_ ? neighbor_heights_by_four(facets_, f, point)
                                             : neighbor_heights(facets_, f, point);
    for (std::size_t i = 0; i < 4; ++i) {
      const FacetIndex g = facet_of(neighbors[i]);
      const bool seen = (heights.visible >> i & 1) != 0;
      const bool nearer = !seen && heights.value[i] > height && !facets_.infinite(g);
      if (!seen && !nearer) continue;
      if (!own(g)) {
        at_border = true;
        continue;
      }
      if (seen) return g;
      f = g;
      height = heights.value[i];
      moved = true;
    }
  }
  return at_border ? kNone : locate_exactly(q, f);
}

/// Visibility walk by exact orientations: ends in the tetrahedron that holds q, or beyond the hull.
/// It ends because the power of q falls with every step.
FacetIndex Inserter::locate_exactly(Site q, FacetIndex from) const {
  FacetIndex f = from;
  for (bool moved = true; moved;) {
    moved = false;
    for (std::uint32_t i = 0; i < 4; ++i) {
      auto p = facets_.corners(f);
      p[i] = q;
      if (orient3d(points_[p[0]], points_[p[1]], points_[p[2]], points_[p[3]]) != Sign::kNegative) {
        continue;
      }
      f = facet_of(facets_.neighbors(f)[i]);
      if (!own(f)) return kNone;
      if (facets_.infinite(f)) return f;
      moved = true;
      break;
    }
  }
  return f;
}

}  // namespace tetsculpt::hull
