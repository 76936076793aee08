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

constexpr std::size_t kLargeCone =
    256;  // above so many corners, pairs are sorted instead of tabulated

}  // namespace

Inserter::Inserter(std::span<const Point3> points, Facets& facets)
    : points_(points),
      facets_(facets),
      number_of_(points.size() + 1, Number{0, 0}),
      half_ridge_(kLargeCone * kLargeCone) {}

Inserter Inserter::helper(SiteRange own) {
  Inserter helper(points_, facets_);
  helper.own_ = own;
  helper.stamp_ = stamp_;
  for (const FacetIndex f : free_) facets_.corners(f).fill(kNone);
  helper.free_ = std::exchange(free_, {});
  // Begin at the end of the range's stretch of the curve where the points will.
  helper.last_ = kNone;
  Site first = kNone;
  for (FacetIndex f = 0; f < facets_.size(); ++f) {
    const Site lowest = std::ranges::min(facets_.corners(f));
    if (lowest >= first || facets_.corners(f)[0] == kNone || !helper.own(f)) continue;
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
      facets_.farthest(f) = conflicts_[apex].next;
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

/// Makes a facet part of the visible region, entered through a ridge, and its other ridges part of
/// the front: their facets are on their way to the cache when their turn comes.
void Inserter::make_visible(FacetIndex f, Ridge through) {
  facets_.mark(f) = stamp_;
  visible_.push_back(f);
  for (std::uint32_t i = 0; i < 4; ++i) {
    if (ridge(f, i) == through) continue;
    const Ridge outer = facets_.neighbors(f)[i];
    facets_.prefetch(facet_of(outer));
    front_.push_back({ridge(f, i), outer});
  }
}

/// Grows the visible region from a facet that the apex sees; what it is cut off by is the horizon.
/// False if the region leaves the range.
bool Inserter::find_horizon(Site apex, FacetIndex seen) {
  stamp_ += 2;
  const std::uint32_t is_hidden = stamp_ + 1;
  visible_.clear();
  front_.clear();
  horizon_.clear();
  make_visible(seen, kNone);
  for (std::size_t k = 0; k < front_.size(); ++k) {
    const auto [inner, outer] = front_[k];
    const FacetIndex g = facet_of(outer);
    std::uint32_t& mark = facets_.mark(g);
    if (mark == stamp_) continue;
    if (mark != is_hidden) {
      if (facets_.visible(g, apex)) {
        if (!own(g)) return false;
        make_visible(g, outer);
        continue;
      }
      mark = is_hidden;
    }
    // The apex takes the place of the corner opposite; a double exchange, which keeps the
    // orientation, puts it first.
    static constexpr std::uint8_t kOthers[4][3] = {{1, 2, 3}, {0, 3, 2}, {3, 0, 1}, {2, 1, 0}};
    const auto& c = facets_.corners(facet_of(inner));
    const auto& others = kOthers[corner_of(inner)];
    horizon_.push_back({{c[others[0]], c[others[1]], c[others[2]]}, outer});
  }
  return true;
}

void Inserter::collect_orphans(Slot apex) {
  orphans_.clear();
  for (const FacetIndex f : visible_) {
    for (Slot k = facets_.farthest(f); k != kNone; k = conflicts_[k].next) {
      if (k != apex) orphans_.push_back(k);
    }
    facets_.farthest(f) = kNone;
  }
  conflicts_[apex].facet = kNone;
}

/// The number of a corner of the horizon; a new one gets its spoke.
std::uint32_t Inserter::number_of(Site s, Site apex) {
  Number& n = number_of_[s == kAtInfinity ? points_.size() : s];
  if (n.stamp != stamp_) {
    n = {stamp_, static_cast<std::uint32_t>(spokes_.size())};
    if (s == kAtInfinity) {
      infinite_number_ = n.number;
      spokes_.push_back({});
    } else {
      spokes_.push_back(spoke(points_[s], points_[apex]));
    }
  }
  return n.number;
}

/// Replaces the visible facets by one facet per horizon ridge, each with the apex as first corner.
void Inserter::make_cone(Site apex) {
  free_.insert(free_.end(), visible_.begin(), visible_.end());
  cone_.clear();
  local_.clear();
  spokes_.clear();
  infinite_number_ = kNone;
  spokes_.reserve(horizon_.size() / 2 + 2);  // by Euler's relation, all of them
  const auto to = [&](std::uint32_t number) {
    return number == infinite_number_ ? nullptr : &spokes_[number];
  };
  for (const auto& [corners, outer] : horizon_) {
    const FacetIndex f = free_.back();
    free_.pop_back();
    facets_.corners(f) = {apex, corners[0], corners[1], corners[2]};
    facets_.neighbors(f)[0] = outer;
    facets_.neighbors(facet_of(outer))[corner_of(outer)] = ridge(f, 0);
    facets_.mark(f) = 0;
    const std::uint32_t a = number_of(corners[0], apex);
    const std::uint32_t b = number_of(corners[1], apex);
    const std::uint32_t c = number_of(corners[2], apex);
    facets_.set_hyperplane(f, to(a), to(b), to(c));
    cone_.push_back(f);
    local_.push_back({a, b, c});
  }
  if (spokes_.size() <= kLargeCone) {
    link_cone();
  } else {
    link_large_cone();
  }
  last_ = cone_[0];
}

/// Each directed edge of the horizon belongs to one ridge, its reverse to the neighbour: a table by
/// pairs of numbers, in which every entry read was written just before.
void Inserter::link_cone() {
  const std::size_t stride = spokes_.size();
  for (std::size_t k = 0; k < cone_.size(); ++k) {
    const auto [a, b, c] = local_[k];
    half_ridge_[b * stride + c] = ridge(cone_[k], 1);
    half_ridge_[c * stride + a] = ridge(cone_[k], 2);
    half_ridge_[a * stride + b] = ridge(cone_[k], 3);
  }
  for (std::size_t k = 0; k < cone_.size(); ++k) {
    const auto [a, b, c] = local_[k];
    auto& neighbors = facets_.neighbors(cone_[k]);
    neighbors[1] = half_ridge_[c * stride + b];
    neighbors[2] = half_ridge_[a * stride + c];
    neighbors[3] = half_ridge_[b * stride + a];
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
      const std::uint64_t a = local_[k][(i + 1) % 3];
      const std::uint64_t b = local_[k][(i + 2) % 3];
      halves.push_back({std::min(a, b) << 32 | std::max(a, b), ridge(cone_[k], i + 1)});
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
    const auto clearly_seen = [&](FacetIndex f) {
      const Facets::Height h = facets_.height(f, q);
      return h.value > h.error;
    };
    auto f = std::ranges::find_if(cone_, clearly_seen);
    if (f == cone_.end()) {
      f = std::ranges::find_if(cone_, [&](FacetIndex g) { return facets_.visible(g, q); });
    }
    assert(f != cone_.end());
    add_conflict(k, *f);
  }
}

/// Puts a point into f's conflict set: first if it is the farthest, else second.
void Inserter::add_conflict(Slot k, FacetIndex f) {
  const double height = facets_.height(f, batch_[k]).value;
  Slot& first = facets_.farthest(f);
  if (first == kNone || height > conflicts_[first].height) {
    conflicts_[k] = {f, first, height};
    first = k;
  } else {
    conflicts_[k] = {f, conflicts_[first].next, height};
    conflicts_[first].next = k;
  }
}

/// A facet that q sees. Walks to neighbours whose sphere has the smaller power of q, which is the
/// side of their common triangle's plane on which q lies; every step is a few multiply-adds, and
/// the walk may end as soon as the power is negative. Rounding can only end it early. kNone where
/// the walk leaves the range.
FacetIndex Inserter::locate(Site q) const {
  FacetIndex f = last_;
  if (f == kNone) return kNone;
  if (const auto i = facets_.infinite_corner(f); i != 4) {
    if (facets_.visible(f, q)) return f;
    f = facet_of(facets_.neighbors(f)[i]);
    if (!own(f)) return kNone;
  }
  Facets::Height h = facets_.height(f, q);
  if (h.value > h.error) return f;
  double power = facets_.power(f, h);
  bool at_border = false;  // of the range
  for (bool moved = true; moved;) {
    moved = false;
    at_border = false;
    for (const Ridge r : facets_.neighbors(f)) {
      const FacetIndex g = facet_of(r);
      h = facets_.height(g, q);
      const bool seen = h.value > h.error;
      const bool nearer = !seen && facets_.infinite_corner(g) == 4 && facets_.power(g, h) < power;
      if (!seen && !nearer) continue;
      if (!own(g)) {
        at_border = true;
        continue;
      }
      if (seen) return g;
      f = g;
      power = facets_.power(g, h);
      moved = true;
      break;
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
      if (facets_.infinite_corner(f) != 4) return f;
      moved = true;
      break;
    }
  }
  return f;
}

}  // namespace tetsculpt::hull
