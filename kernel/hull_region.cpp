#include "kernel/hull_region.h"

#include "kernel/hull_lanes.h"

namespace tetsculpt::hull {
namespace {

/// Decides what was unclear: what is visible after all goes to the visible facets, the other facets
/// stay, behind the first `hidden`.
void decide(const Facets& facets, Site apex, std::size_t& hidden, Region& region) {
  const std::size_t size = region.visible.size();
  const std::size_t open = region.unclear.size() - hidden;
  Ridge* const visible = region.visible.room_for(size + open) + size;
  std::size_t count = 0;
  for (const Ridge r : region.unclear.held().subspan(hidden)) {
    const bool sees = facets.decide(facet_of(r), apex);
    visible[count] = r;
    region.unclear[hidden] = r;
    count += sees;
    hidden += !sees;
  }
  region.visible.hold(size + count);
  region.unclear.hold(hidden);
}

/// Cuts off the facets that turned out to be hidden.
void cut_off_unclear(Facets& facets, Region& region) {
  for (const Ridge r : region.visible) facets.mark(facet_of(r)) = Mark::kVisible;
  std::size_t size = region.cut.size();
  Ridge* const cut = region.cut.room_for(size + 4 * region.visible.size());
  for (const Ridge r : region.visible) {
    const auto& neighbors = facets.neighbors(facet_of(r));
    for (std::uint32_t i = 0; i < 4; ++i) {
      cut[size] = ridge(facet_of(r), i);
      size += facets.mark(facet_of(neighbors[i])) == Mark::kUnclear;
    }
  }
  region.cut.hold(size);
}

}  // namespace

void Region::unmark(Facets& facets) {
  for (const Ridge r : visible) facets.mark(facet_of(r)) = Mark::kUnmet;
  for (const Ridge r : unclear) facets.mark(facet_of(r)) = Mark::kUnmet;
}

bool grow_region(Facets& facets, Site apex, FacetIndex seen, const Range& own, bool by_four,
                 Region& region) {
  const LiftedDifference point = facets.lifted(facets.point(apex));
  region.visible.room_for(1)[0] = ridge(seen, 0);
  region.visible.hold(1);
  region.unclear.hold(0);
  region.cut.hold(0);
  if (!own.owns(facets[seen])) {
    region.visible.hold(0);  // nor may it be marked
    return false;
  }
  facets.mark(seen) = Mark::kVisible;
  const auto expand = by_four ? expand_by_four : hull::expand;
  std::size_t hidden = 0;
  for (std::size_t begin = 0;;) {
    if (!expand(facets, point, own, begin, region)) return false;
    begin = region.visible.size();
    if (hidden == region.unclear.size()) break;
    decide(facets, apex, hidden, region);
  }
  if (hidden > 0) cut_off_unclear(facets, region);
  return true;
}

}  // namespace tetsculpt::hull
