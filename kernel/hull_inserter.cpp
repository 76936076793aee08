// Where points come from and in which order is kernel/lifted_hull's business.
#include "kernel/hull_inserter.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace tetsculpt::hull {

Inserter::Inserter(std::span<const Point3> points, Facets& facets, std::vector<FacetRoom> rooms,
                   bool by_four, std::span<FacetIndex> known)
    : points_(points),
      facets_(facets),
      by_four_(by_four),
      rooms_(std::move(rooms)),
      known_(known),
      cone_(points, facets, by_four) {}

void Inserter::mark_free() {
  for (const Ridge r : free_) facets_.set_dead(facet_of(r));
}

void Inserter::give_back() {
  mark_free();
  facets_.give_back(std::exchange(rooms_, {}));
}

Inserter Inserter::helper() {
  Inserter helper(points_, facets_, std::exchange(rooms_, {}), by_four_, known_);
  helper.free_ = std::exchange(free_, {});
  return helper;
}

void Inserter::move_to(SiteRange own, std::span<const Site> sites, std::size_t site_count) {
  constexpr Site kEvery = 8;  // they lie anywhere in memory
  own_ = own;
  last_ = kNone;
  untried_ = next_untried_ = 0;
  if (sites.empty()) return;
  const auto look = [&](Site begin, Site end) {
    for (Site s = begin; s < end; ++s) {
      if (!own_.contains(s) || known_[s] == kNone) continue;
      if (s % kEvery != 0 || !at_site(known_[s], s) || !this->own(known_[s])) known_[s] = kNone;
    }
  };
  const Site begin = sites.front() - std::min(sites.front(), kBack);
  const Site end = sites.back() + 1;
  if (sites.front() < end) {
    look(begin, end);
  } else {  // beyond the curve's end
    look(begin, static_cast<Site>(site_count));
    look(0, end);
  }
}

void Inserter::begin_at_last_of(const Inserter& helper) {
  if (helper.last_ != kNone) last_ = helper.last_;
}

void Inserter::take_over(const Inserter& helper) {
  free_.insert(free_.end(), helper.free_.begin(), helper.free_.end());
  rooms_.insert(rooms_.end(), helper.rooms_.begin(), helper.rooms_.end());
}

bool Inserter::own(FacetIndex f) const { return own_.all() || own_.contains(facets_.corners(f)); }

/// Whether it lives and is at that site.
bool Inserter::at_site(FacetIndex f, Site s) const {
  return facets_.lives(f) && std::ranges::find(facets_.corners(f), s) != facets_.corners(f).end();
}

void Inserter::insert(Site q) {
  if (untried_ > 0) {
    --untried_;
    deferred_.push_back(q);
    return;
  }
  const FacetIndex seen = locate(q);
  if (seen != kNone && find_horizon(q, seen)) {
    replace_visible(q);
    next_untried_ = 0;
  } else {
    defer_at_border(q);
  }
}

/// To find that a point can't go in takes as long as to insert it, and of a bumpy sphere 96 % of
/// the points after such a one can't, either, 81 % of a cube's.
void Inserter::defer_at_border(Site q) {
  constexpr std::size_t kMostUntried = 8;
  deferred_.push_back(q);
  untried_ = next_untried_;
  next_untried_ = std::min(2 * next_untried_ + 1, kMostUntried);
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
    for (FacetIndex f = room.begin; f-- > begin;) free_.push_back(ridge(f, 0));
    if (room.size() == 0) rooms_.pop_back();
  }
  return true;
}

/// Replaces the visible facets by those of a cone.
void Inserter::replace_visible(Site apex) {
  const std::size_t left = free_.size() - region_.cut.size();
  cone_.put_up(apex, region_, std::span(free_).subspan(left));
  last_ = cone_.facets()[0].facet;
  if (facets_.on_sphere(apex)) {
    const auto infinite = [&](const ConeFacet& c) { return facets_.infinite(c.facet); };
    const auto c = std::ranges::find_if(cone_.facets(), infinite);
    if (c != cone_.facets().end()) last_ = c->facet;
  }
  if (!known_.empty()) known_[apex] = last_;
  free_visible(left);
}

/// Of the free facets the first so many are left; visible ones follow them.
void Inserter::free_visible(std::size_t left) {
  if (!own_.all()) {
    for (const Ridge r : region_.visible) facets_.set_dead(facet_of(r));
  }
  const std::size_t size = region_.visible.size();
  free_.resize(left + size);
  // The next insertion uses up what dies now, and then those before, which may be in no cache.
  constexpr std::size_t kAhead = 12;
  for (std::size_t k = left - std::min(kAhead, left); k < left; ++k) {
    facets_.prefetch(facet_of(free_[k]));
  }
  std::memcpy(&free_[left], region_.visible.begin(), size * sizeof(Ridge));
}

}  // namespace tetsculpt::hull
