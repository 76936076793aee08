// Where points come from and in which order is kernel/lifted_hull's business.
#include "kernel/hull_inserter.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace tetsculpt::hull {
namespace {

/// Cones with more numbers than this are linked by sorting.
constexpr std::size_t kTabled = 512;

/// Per number, one of which a + 2 b tells both: a bit of the number in each second bit.
constexpr auto kTablePlaces = [] {
  std::array<std::uint32_t, kTabled> places{};
  for (std::uint32_t k = 1; k < kTabled; ++k) places[k] = 4 * places[k / 2] + k % 2;
  return places;
}();

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
      number_of_(points.size() + 1) {}

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
  return helper;
}

void Inserter::look_around() {
  constexpr Site kEvery = 8;  // they lie anywhere in memory
  for (Site s = 0; s < known_.size(); ++s) {
    if (!own_.contains(s) || known_[s] == kNone) continue;
    if (s % kEvery != 0 || !at_site(known_[s], s) || !own(known_[s])) known_[s] = kNone;
  }
}

void Inserter::take_over(const Inserter& helper) {
  free_.insert(free_.end(), helper.free_.begin(), helper.free_.end());
  rooms_.insert(rooms_.end(), helper.rooms_.begin(), helper.rooms_.end());
  if (helper.last_ != kNone) last_ = helper.last_;
}

bool Inserter::own(FacetIndex f) const { return own_.all() || own_.contains(facets_.corners(f)); }

/// Whether it lives and is at that site.
bool Inserter::at_site(FacetIndex f, Site s) const {
  return facets_.lives(f) && std::ranges::find(facets_.corners(f), s) != facets_.corners(f).end();
}

void Inserter::insert(Site q) {
  const FacetIndex seen = locate(q);
  if (seen != kNone && find_horizon(q, seen)) {
    make_cone(q);
  } else {
    deferred_.push_back(q);
  }
}

/// False, and nothing has changed, if the visible region leaves the range or if there are no facets
/// for the cone.
bool Inserter::find_horizon(Site apex, FacetIndex seen) {
  if (grow_region(facets_, apex, seen, own_, by_four_, region_)) {
    const std::size_t size = region_.cut.size();
    if (free_.size() >= size || find_room(size)) return true;
  }
  region_.unmark(facets_);
  return false;
}

/// Sees to it that so many facets are free; false if the store has no room for them.
bool Inserter::find_room(std::size_t count) {
  constexpr std::size_t kAtOnce = 256;
  while (free_.size() < count) {
    if (rooms_.empty()) {
      const FacetRoom appended = facets_.append(count);
      if (appended.size() == 0) return false;
      facets_.touch(appended);
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

/// Replaces the visible facets by one facet per ridge that is cut, each with the apex as first
/// corner.
void Inserter::make_cone(Site apex) {
  number_corners();
  if (spoke_ends_.size() <= kTabled) {
    put_up_cone<true>(apex);
    link_cone();
  } else {
    put_up_cone<false>(apex);
    link_large_cone();
  }
  set_hyperplanes(apex);
  replace_visible();
  last_ = cone_[0].facet;
  if (facets_.on_sphere(apex)) {
    const auto infinite = [&](const ConeFacet& c) { return facets_.infinite(c.facet); };
    if (const auto* c = std::find_if(cone_.begin(), cone_.end(), infinite); c != cone_.end()) {
      last_ = c->facet;
    }
  }
  if (!known_.empty()) known_[apex] = last_;
}

/// The visible facets are free, those of the cone are not.
void Inserter::replace_visible() {
  if (!own_.all()) {
    for (const Ridge r : region_.visible) facets_.set_dead(facet_of(r));
  }
  const std::size_t left = free_.size() - cone_.size();
  free_.resize(left + region_.visible.size());
  // The next insertion uses up what dies now, and then those before, which may be in no cache.
  constexpr std::size_t kAhead = 12;
  for (std::size_t k = left - std::min(kAhead, left); k < left; ++k) facets_.prefetch(free_[k]);
  for (std::size_t k = 0; k < region_.visible.size(); ++k) {
    free_[left + k] = facet_of(region_.visible[k]);
  }
}

/// Numbers the corners of visible facets, which lose their marks. A facet was met through a ridge,
/// which leaves one corner that may be new: it takes the facet's number. The last number counts.
inline void Inserter::number_corners() {
  const std::size_t count = region_.visible.size() + 3;
  Site* const ends = spoke_ends_.room_for(in_fours(count));
  const auto last_site = static_cast<Site>(points_.size() - 1);
  number_of(kAtInfinity) = kNone;
  const auto set_number = [&](std::size_t n, Site s) {
    number_of(s) = static_cast<std::uint32_t>(n);
    ends[n] = std::min(s, last_site);  // any for infinity
  };
  const auto& first = facets_.corners(facet_of(region_.visible[0]));
  for (std::size_t i = 1; i < 4; ++i) set_number(i - 1, first[i]);
  for (std::size_t k = 0; k < region_.visible.size(); ++k) {
    const Ridge r = region_.visible[k];
    set_number(k + 3, facets_.corners(facet_of(r))[corner_of(r)]);
    facets_.mark(facet_of(r)) = Mark::kUnmet;
  }
  for (const Ridge r : region_.unclear) facets_.mark(facet_of(r)) = Mark::kUnmet;
  for (std::size_t n = count; n < in_fours(count); ++n) ends[n] = last_site;
  spoke_ends_.hold(count);
}

/// The cone's facets, linked to those outside; notes what is to be linked among them.
template <bool kInTable>
inline void Inserter::put_up_cone(Site apex) {
  // The apex takes the place of the corner opposite; a double exchange, which keeps the
  // orientation, puts it first. What was last stays last if it is there: it may be at infinity.
  static constexpr std::uint8_t kOthers[4][4] = {{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {2, 1, 0}};
  ConeFacet* const cone = cone_.room_for(region_.cut.size() + 3);
  const FacetIndex* const free = free_.data() + (free_.size() - region_.cut.size());
  Ridge* const half_ridge =
      half_ridge_.room_for(kInTable ? 3 * kTablePlaces[spoke_ends_.size() - 1] + 1 : 0);
  for (std::size_t k = 0; k < region_.cut.size(); ++k) {
    const Ridge inner = region_.cut[k];
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
    const std::uint32_t i = number_of(a);
    const std::uint32_t j = number_of(b);
    const std::uint32_t l = number_of(c);
    cone[k] = {f, {i, j, l}};
    if constexpr (kInTable) {
      half_ridge[2 * kTablePlaces[j] + kTablePlaces[l]] = ridge(f, 1);
      half_ridge[2 * kTablePlaces[l] + kTablePlaces[i]] = ridge(f, 2);
      half_ridge[2 * kTablePlaces[i] + kTablePlaces[j]] = ridge(f, 3);
    }
  }
  cone_.hold(region_.cut.size());
  for (std::size_t k = 0; k < 3; ++k) cone[region_.cut.size() + k] = cone[k];
}

/// Each directed edge of the horizon belongs to one facet of the cone, its reverse to the
/// neighbour: a table by pairs of numbers, in which every entry read was written just before.
inline void Inserter::link_cone() {
  const Ridge* const half_ridge = half_ridge_.begin();
  for (const auto& [f, numbers] : cone_) {
    const std::uint32_t a = kTablePlaces[numbers[0]];
    const std::uint32_t b = kTablePlaces[numbers[1]];
    const std::uint32_t c = kTablePlaces[numbers[2]];
    auto& neighbors = facets_.neighbors(f);
    neighbors[1] = half_ridge[2 * c + b];
    neighbors[2] = half_ridge[2 * a + c];
    neighbors[3] = half_ridge[2 * b + a];
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

void Inserter::set_hyperplanes(Site apex) {
  const std::size_t count = spoke_ends_.size();
  Spoke* const spokes = spokes_.room_for(in_fours(count));
  const auto to_spokes = by_four_ ? set_spokes_by_four : set_spokes;
  to_spokes(points_, apex, {spoke_ends_.begin(), in_fours(count)}, spokes);
  const std::uint32_t infinity = number_of(kAtInfinity);
  if (infinity != kNone) spokes[infinity] = facets_.spoke_to_infinity();
  const auto to_hyperplanes = by_four_ ? set_hyperplanes_by_four : hull::set_hyperplanes;
  to_hyperplanes(facets_, apex, cone_.held(), {spokes, count});
}

}  // namespace tetsculpt::hull
