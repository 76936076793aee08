// The four steps of Quickhull are in insert_farthest; where points come from and in which order is
// kernel/lifted_hull's business.
#include "kernel/hull_inserter.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace tetsculpt::hull {
namespace {

// Pairs of the horizon's corners are tabulated, for few of them in a table that fits in the nearest
// cache; above the larger size they are sorted.
constexpr std::size_t kSmallCone = 32;
constexpr std::size_t kLargeCone = 256;

/// The same, but the compiler can't know what it is: it would branch on where the number is from.
inline std::uint32_t opaque(std::uint32_t number) {
  asm("" : "+r"(number));
  return number;
}

/// The next multiple of four.
constexpr std::size_t in_fours(std::size_t n) { return (n + 3) & ~std::size_t{3}; }

}  // namespace

Inserter::Inserter(std::span<const Point3> points, Facets& facets, std::vector<FacetRoom> rooms,
                   bool by_four, std::span<FacetIndex> known)
    : points_(points),
      facets_(facets),
      by_four_(by_four),
      rooms_(std::move(rooms)),
      known_(known),
      number_of_(points.size() + 1, 0),
      half_ridge_(kLargeCone * kLargeCone) {}

void Inserter::mark_free() {
  for (const FacetIndex f : free_) facets_.set_dead(f);
}

void Inserter::give_back() {
  mark_free();
  facets_.give_back(std::exchange(rooms_, {}));
}

Inserter Inserter::helper(SiteRange own) {
  Inserter helper(points_, facets_, std::exchange(rooms_, {}), by_four_, known_);
  helper.free_ = std::exchange(free_, {});
  helper.own_ = own;
  helper.last_ = kNone;
  helper.first_number_ = 1;
  return helper;
}

void Inserter::look_around() {
  for (Site s = 0; s < known_.size(); ++s) {
    if (!own_.contains(s) || known_[s] == kNone) continue;
    if (!at_site(known_[s], s) || !own(known_[s])) known_[s] = kNone;
  }
}

void Inserter::take_over(const Inserter& helper) {
  free_.insert(free_.end(), helper.free_.begin(), helper.free_.end());
  rooms_.insert(rooms_.end(), helper.rooms_.begin(), helper.rooms_.end());
  if (helper.last_ != kNone) last_ = helper.last_;
}

bool Inserter::own(FacetIndex f) const { return own_.all() || own_.contains(facets_.corners(f)); }

bool Inserter::all_own(std::span<const FacetIndex> facets) const {
  return std::ranges::all_of(facets, [&](FacetIndex f) { return own(f); });
}

/// Whether it lives and is at that site.
bool Inserter::at_site(FacetIndex f, Site s) const {
  return facets_.lives(f) && std::ranges::find(facets_.corners(f), s) != facets_.corners(f).end();
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
  if (free_.size() < cut_.size() && !find_room(cut_.size())) {
    forget(visible_.size());
    return false;
  }
  collect_orphans(slot);
  make_cone(apex);
  reassign_conflicts();
  return true;
}

/// Sees to it that so many facets are free; false if the store has no room for them.
bool Inserter::find_room(std::size_t count) {
  constexpr std::size_t kAtOnce = 256;
  while (free_.size() < count) {
    if (rooms_.empty()) {
      const FacetRoom appended = facets_.append(count);
      if (appended.size() == 0) return false;
      rooms_.push_back(appended);
    }
    FacetRoom& room = rooms_.back();
    const FacetIndex begin = room.begin;
    room.begin += static_cast<FacetIndex>(std::min(kAtOnce, room.size()));
    for (FacetIndex f = room.begin; f-- > begin;) free_.push_back(f);
    if (room.size() == 0) rooms_.pop_back();
  }
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

/// Grows the visible region from a facet that the apex sees, in waves: what a wave's neighbours are
/// that were not met before, and which of them are visible. No branch depends on either. What the
/// region is cut off by is the horizon. False if the region leaves the range.
bool Inserter::find_horizon(Site apex, FacetIndex seen) {
  const LiftedDifference lifted_apex = facets_.lifted(points_[apex]);
  visible_.room_for(1)[0] = seen;
  visible_.hold(1);
  facets_.mark(seen) = Mark::kMet;
  for (std::size_t begin = 0; begin < visible_.size();) {
    const std::span<const FacetIndex> wave = visible_.held().subspan(begin);
    if (!own_.all() && !all_own(wave)) {
      forget(begin);
      return false;
    }
    begin = visible_.size();
    meet_neighbors(wave);
    sort_met(apex, lifted_apex);
  }
  cut_out();
  return true;
}

/// Takes away the marks of what the first visible facets met.
void Inserter::forget(std::size_t visible_count) {
  facets_.mark(visible_[0]) = Mark::kUnmet;
  for (const FacetIndex f : visible_.held().first(visible_count)) {
    for (const Ridge r : facets_.neighbors(f)) facets_.mark(facet_of(r)) = Mark::kUnmet;
  }
}

/// Lists the neighbours that were not met before. They count as hidden for now.
inline void Inserter::meet_neighbors(std::span<const FacetIndex> wave) {
  FacetIndex* const met = met_.room_for(4 * wave.size() + 4);
  std::size_t size = 0;
  for (const FacetIndex f : wave) {
    const std::array<Ridge, 4> neighbors = facets_.neighbors(f);
    for (std::uint32_t i = 0; i < 4; ++i) {
      const FacetIndex g = facet_of(neighbors[i]);
      facets_.prefetch(g);
      met[size] = g;
      size += std::exchange(facets_.mark(g), Mark::kMet) == Mark::kUnmet;
    }
  }
  met_.hold(size);
  for (std::size_t i = 0; i < 3; ++i) met[size + i] = visible_[0];
}

/// Adds those of the met facets that the apex sees to the visible ones.
inline void Inserter::sort_met(Site apex, const LiftedDifference& lifted_apex) {
  const std::size_t size = visible_.size();
  FacetIndex* const visible = visible_.room_for(size + met_.size() + 4) + size;
  FacetIndex* const unclear = unclear_.room_for(met_.size() + 4);
  const auto sort = by_four_ ? sort_by_view_by_four : sort_by_view;
  Counts counts = sort(facets_, met_.held(), lifted_apex, visible, unclear);
  for (std::size_t k = 0; k < counts.unclear; ++k) {
    if (facets_.decide(unclear[k], apex)) visible[counts.visible++] = unclear[k];
  }
  visible_.hold(size + counts.visible);
}

/// The horizon: the ridges between a visible facet and a hidden one.
inline void Inserter::cut_out() {
  for (const FacetIndex f : visible_) facets_.mark(f) = Mark::kUnmet;
  Ridge* const cut = cut_.room_for(4 * visible_.size() + 1);
  std::size_t size = 0;
  for (const FacetIndex f : visible_) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      cut[size] = ridge(f, i);
      size += static_cast<std::size_t>(facets_.mark(facet_of(facets_.neighbors(f)[i])));
    }
  }
  cut_.hold(size);
}

/// Lists the points whose facets the apex sees.
void Inserter::collect_orphans(Slot apex) {
  Slot* const orphans = orphans_.room_for(batch_.size());
  std::size_t size = 0;
  conflicts_[apex].facet = kNone;
  for (Slot k = 0; k < batch_.size(); ++k) {
    const FacetIndex f = conflicts_[k].facet;
    if (f != kNone && facets_.visible(f, batch_[apex])) orphans[size++] = k;
  }
  orphans_.hold(size);
}

/// Replaces the visible facets by one facet per horizon ridge, each with the apex as first corner.
void Inserter::make_cone(Site apex) {
  const auto corner_count = static_cast<std::uint32_t>(cut_.size() / 2 + 2);  // Euler's relation
  if (first_number_ > kNone - corner_count) {
    std::ranges::fill(number_of_, 0);
    first_number_ = 1;
  }
  if (corner_count <= kSmallCone) {
    put_up_cone<kSmallCone>(apex);
    link_cone<kSmallCone>();
  } else if (corner_count <= kLargeCone) {
    put_up_cone<kLargeCone>(apex);
    link_cone<kLargeCone>();
  } else {
    put_up_cone<0>(apex);
    link_large_cone();
  }
  set_geometry(apex, corner_count);
  first_number_ += corner_count;
  if (!own_.all()) {
    for (const FacetIndex f : visible_) facets_.set_dead(f);
  }
  free_.resize(free_.size() - cone_.size());
  // The next insertion uses up what dies now, and then these, which may be in no cache.
  constexpr std::size_t kAhead = 12;
  for (std::size_t k = 0; k < std::min(kAhead, free_.size()); ++k) {
    facets_.prefetch(free_[free_.size() - 1 - k]);
  }
  free_.insert(free_.end(), visible_.begin(), visible_.end());
  last_ = cone_[0].facet;
  if (facets_.on_sphere(apex)) {
    const auto infinite = [&](const ConeFacet& c) { return facets_.infinite(c.facet); };
    if (const auto* c = std::find_if(cone_.begin(), cone_.end(), infinite); c != cone_.end()) {
      last_ = c->facet;
    }
  }
  if (!known_.empty()) known_[apex] = last_;
}

/// The cone's facets, linked to those outside; numbers its corners and notes what is to be linked
/// among its facets, see link_cone.
template <std::size_t kStride>
void Inserter::put_up_cone(Site apex) {
  // The apex takes the place of the corner opposite; a double exchange, which keeps the
  // orientation, puts it first. What was last stays last if it is there: it may be at infinity.
  static constexpr std::uint8_t kOthers[4][3] = {{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {2, 1, 0}};
  ConeFacet* const cone = cone_.room_for(cut_.size() + 3);
  const FacetIndex* const free = free_.data() + (free_.size() - cut_.size());
  Site* const ends = spoke_ends_.room_for(cut_.size() / 2 + 6);
  std::uint32_t* const number_of = number_of_.data() + 1;
  Ridge* const half_ridge = half_ridge_.data();
  const std::uint32_t first = first_number_;
  std::uint32_t count = 0;
  // A new one if it has none: no branch depends on that.
  const auto number = [&](Site s) {
    std::uint32_t& known = number_of[static_cast<std::int32_t>(s)];
    const std::uint32_t before = known - first;  // of earlier horizons: more than count
    const std::uint32_t n = opaque(std::min(before, count));
    known = first + n;
    ends[n] = s;
    count += before >= count;
    return n;
  };
  for (std::size_t k = 0; k < cut_.size(); ++k) {
    const Ridge inner = cut_[k];
    const FacetLinks& seen = facets_[facet_of(inner)].links;
    const Ridge outer = seen.neighbors[corner_of(inner)];
    const auto& others = kOthers[corner_of(inner)];
    const Site a = seen.corners[others[0]];
    const Site b = seen.corners[others[1]];
    const Site c = seen.corners[others[2]];
    const FacetIndex f = free[k];
    facets_.corners(f) = {apex, a, b, c};
    facets_.neighbors(f)[0] = outer;
    facets_.neighbors(facet_of(outer))[corner_of(outer)] = ridge(f, 0);
    facets_.mark(facet_of(outer)) = Mark::kUnmet;
    const std::uint32_t i = number(a);
    const std::uint32_t j = number(b);
    const std::uint32_t l = number(c);
    cone[k] = {f, {i, j, l}};
    if constexpr (kStride > 0) {
      half_ridge[j * kStride + l] = ridge(f, 1);
      half_ridge[l * kStride + i] = ridge(f, 2);
      half_ridge[i * kStride + j] = ridge(f, 3);
    }
  }
  assert(count == cut_.size() / 2 + 2);
  cone_.hold(cut_.size());
  for (std::size_t k = 0; k < 3; ++k) cone[cut_.size() + k] = cone[k];
}

/// The hyperplanes of the cone, which has so many corners besides the apex.
void Inserter::set_geometry(Site apex, std::size_t corner_count) {
  const std::size_t padded = in_fours(corner_count);
  Site* const ends = spoke_ends_.room_for(padded);
  for (std::size_t k = corner_count; k < padded; ++k) ends[k] = apex;
  const std::uint32_t infinity = number_of_[0] - first_number_;  // large if it is no corner
  if (infinity < corner_count) ends[infinity] = apex;
  Spoke* const spokes = spokes_.room_for(padded);
  const auto to_spokes = by_four_ ? set_spokes_by_four : set_spokes;
  to_spokes(points_, apex, {ends, padded}, spokes);
  if (infinity < corner_count) spokes[infinity] = facets_.spoke_to_infinity();
  const auto to_hyperplanes = by_four_ ? set_hyperplanes_by_four : set_hyperplanes;
  to_hyperplanes(facets_, apex, cone_.held(), {spokes, corner_count});
}

/// Each directed edge of the horizon belongs to one ridge, its reverse to the neighbour: a table by
/// pairs of numbers, in which every entry read was written just before.
template <std::size_t kStride>
void Inserter::link_cone() {
  const Ridge* const half_ridge = half_ridge_.data();
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
    const LiftedDifference point = facets_.lifted(points_[q]);
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
  conflicts_[k] = {f, facets_.height(f, facets_.lifted(points_[batch_[k]])).value};
}

}  // namespace tetsculpt::hull
