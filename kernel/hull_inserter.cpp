// Where points come from and in which order is kernel/lifted_hull's business.
#include "kernel/hull_inserter.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <numeric>
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
  for (; marked_free_ < free_.size(); ++marked_free_) {
    facets_.set_dead(facet_of(free_[marked_free_]));
  }
}

void Inserter::give_back() {
  mark_free();
  facets_.give_back(std::exchange(rooms_, {}));
}

std::size_t Inserter::unused() const {
  const auto add = [](std::size_t sum, const FacetRoom& room) { return sum + room.size(); };
  return std::accumulate(rooms_.begin(), rooms_.end(), free_.size(), add);
}

void Inserter::take_over(Inserter& other) {
  free_.insert(free_.end(), other.free_.begin(), other.free_.end());
  rooms_.insert(rooms_.end(), other.rooms_.begin(), other.rooms_.end());
  other.free_.clear();
  other.marked_free_ = 0;
  other.rooms_.clear();
}

void Inserter::move_to(const Range& range, const SiteSet& sites) noexcept {
  own_ = range;
  last_ = kNone;
  beyond_.clear();
  constexpr Site kAhead = 16;
  const auto groups = static_cast<Site>(known_.size());
  Site next = 0;  // groups before this one are done
  for (Site block = 0; block < sites.block_count(); ++block) {
    if (sites.count_in(block) == 0 || !own_.sites().contains(block * kBlock)) continue;
    const Site first = block * (kBlock / kGroup);
    const Site end = std::min(first + kBlock / kGroup, groups);
    for (next = std::max(next, first - std::min(first, kBack)); next < end; ++next) {
      const Site ahead = std::min(next + kAhead, groups - 1);
      if (own_.sites().contains(ahead * kGroup) && known_[ahead] != kNone) {
        facets_.prefetch(known_[ahead] & ~kBarred);  // it lies anywhere in memory
      }
      if (!own_.sites().contains(next * kGroup) || known_[next] == kNone) continue;
      const FacetIndex f = known_[next] & ~kBarred;
      known_[next] = !in_group(f, next) ? kNone : own(f) ? f : f | kBarred;
      if (last_ == kNone && known_[next] < kBarred) last_ = f;
    }
  }
}

void Inserter::begin_at_last_of(const Inserter& helper) {
  if (helper.last_ != kNone) last_ = helper.last_;
}

bool Inserter::own(FacetIndex f) const { return own_.owns(facets_[f]); }

/// Not if it has a neighbour that is another's, where facets go by their centers.
bool Inserter::replaceable(FacetIndex f) const {
  const auto owns = [&](Ridge r) { return own(facet_of(r)); };
  return own(f) && (!own_.centers() || std::ranges::all_of(facets_.neighbors(f), owns));
}

/// Whether it lives and is at a site of that group.
bool Inserter::in_group(FacetIndex f, Site group) const {
  const auto in_it = [&](Site s) { return s / kGroup == group; };
  return facets_.lives(f) && std::ranges::any_of(facets_.corners(f), in_it);
}

bool Inserter::insert(Site q) {
  if (sees_beyond(q)) return false;
  const FacetIndex seen = locate(q);
  if (seen == kNone) return false;
  if (!find_horizon(q, seen)) {
    remember_beyond(seen);
    return false;
  }
  replace_visible(q);
  if (!beyond_.empty()) beyond_.erase(beyond_.begin());
  return true;
}

Inserter::Tally Inserter::insert_all(SiteSet& sites,
                                     const std::function<bool(std::size_t)>& go_on) {
  Tally tally;
  const auto attempt = [&](Site s) {
    if (!go_on(tally.tried)) return false;
    ++tally.tried;
    if (!insert(s)) return true;
    sites.erase(s);
    ++tally.inserted;
    return true;
  };
  for (Site block = 0; block < sites.block_count(); ++block) {
    if (own_.sites().contains(block * kBlock) && !sites.each_in(block, attempt)) break;
  }
  mark_free();
  return tally;
}

/// Whether it clearly sees one of the facets beyond the range that are remembered, and so can't go
/// in. To find that out by growing a region takes as long as to insert it. Of a bumpy sphere's
/// points that can't go in three quarters see one of these.
bool Inserter::sees_beyond(Site q) {
  const LiftedDifference point = facets_.lifted(points_[q]);
  for (std::size_t k = beyond_.size(); k-- > 0;) {
    const Facets::Height h = facets_.height(beyond_[k], point);
    if (!(h.value > h.error)) continue;
    const auto found = beyond_.begin() + static_cast<std::ptrdiff_t>(k);
    std::rotate(found, found + 1, beyond_.end());
    return true;
  }
  return false;
}

/// After a region that began at `seen` has left the range, or found no room.
void Inserter::remember_beyond(FacetIndex seen) {
  constexpr std::size_t kMost = 8;
  if (!own(seen)) beyond_.push_back(seen);
  for (const Ridge r : region_.visible) {
    if (!replaceable(facet_of(r))) beyond_.push_back(facet_of(r));
  }
  if (beyond_.size() > kMost) {
    beyond_.erase(beyond_.begin(), beyond_.end() - kMost);
  }
  if (own(seen)) last_ = seen;  // the next point is near this one
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
  if (!known_.empty()) known_[apex / kGroup] = last_;
  free_visible(left);
}

/// Of the free facets the first so many are left; visible ones follow them.
void Inserter::free_visible(std::size_t left) {
  marked_free_ = std::min(marked_free_, left);
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
