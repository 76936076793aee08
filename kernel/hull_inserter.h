#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "kernel/hull_cone.h"
#include "kernel/hull_facets.h"
#include "kernel/hull_range.h"
#include "kernel/hull_region.h"
#include "kernel/hull_sites.h"
#include "kernel/point.h"

/// Quickhull with one point at a time. Internal to kernel/lifted_hull.
namespace tetsculpt::hull {

/// So many sites one behind the other, a part of a block, share a facet that is known, see
/// Inserter.
inline constexpr Site kGroup = 8;

/// Inserts points into a hull. Several may work on one hull at a time if their ranges are disjoint:
/// one replaces only facets all of whose corners are its own, and reads only those, their
/// neighbours, which it marks and links to new ones, and the finite facet behind an infinite
/// neighbour. A facet with three corners that are its own or at infinity is out of all others'
/// reach, because they would need three, too, and there is one at infinity only; so is one with two
/// corners that are its own and none at infinity.
///     By centers, one replaces only facets in its box whose neighbours are all there, too, and
/// marks and links no others. So where one of two neighbours is in a box and the other is not,
/// neither is replaced, nor the link between them changed, as long as the ranges stay. Of the
/// facets that one puts up some may be outside of its box, even in another's: only it can reach
/// those, because only links of its own facets and of others of the kind lead there, and they and
/// their neighbours stay, too. What a point sees is connected: nothing that another puts up becomes
/// part of what this one replaces, so the hull is as if one had done so after the other.
class alignas(64) Inserter {  // two threads' don't share a cache line
 public:
  /// With all sites for its range. Facet 0 lives. `by_four` where has_four_lanes(). `known`, if
  /// there will be helpers, holds a facet per group of sites that has one, or kNone.
  Inserter(std::span<const Point3> points, Facets& facets, std::vector<FacetRoom> rooms,
           bool by_four, std::span<FacetIndex> known);
  /// Marks the facets at hand for the next insertions as dead, which must be done before anybody
  /// else asks what lives; insert_all() does so at its end. To do so with each as it is appended
  /// would sweep the nearest cache: 6 % of the hull.
  void mark_free();
  /// Marks them and gives back what was never used: nothing is inserted any more.
  void give_back();
  /// How many facets it has that are not in the hull.
  std::size_t unused() const;
  /// One that has no facets for new cones yet, see take_over(), and must move_to() a range before
  /// anything is inserted.
  Inserter helper() const { return {points_, facets_, {}, by_four_, known_}; }
  /// Takes what another one has left of its facets.
  void take_over(Inserter& other);
  /// Gives a helper the range in which it will insert these. Of the facets that are known near them
  /// it keeps those that live, and bars those that are not its own. All helpers may do so at a
  /// time, while none inserts.
  void move_to(const Range& range, const SiteSet& sites) noexcept;
  /// Begins the next walk where a helper would, if it knows where. Must come before helpers move:
  /// then what was there before may go.
  void begin_at_last_of(const Inserter& helper);

  /// Inserts a point. False, and nothing has changed, if it needs facets outside of the range or
  /// more memory than the store has, or seems to.
  bool insert(Site q);
  struct Tally {
    std::size_t tried = 0;
    std::size_t inserted = 0;
  };
  /// Inserts those of the sites that are in its range and can go in, and erases them, in ascending
  /// order and while go_on() is true of how many were tried.
  Tally insert_all(SiteSet& sites, const std::function<bool(std::size_t)>& go_on);

 private:
  /// How many groups before a site's, along the curve, it looks back for one with a facet.
  static constexpr Site kBack = 8;

  /// Marks a known facet that is not in the range: others may change it.
  static constexpr FacetIndex kBarred = FacetIndex{1} << 31;

  bool own(FacetIndex f) const;
  bool replaceable(FacetIndex f) const;
  bool in_group(FacetIndex f, Site group) const;
  // See hull_locate.cpp.
  FacetIndex locate(Site q);
  FacetIndex walk(Site q, FacetIndex f) const;
  FacetIndex walk_on_hull(Site q, FacetIndex f) const;
  FacetIndex locate_exactly(Site q, FacetIndex from) const;

  bool sees_beyond(Site q);
  void remember_beyond(FacetIndex seen);
  bool find_horizon(Site apex, FacetIndex seen);
  bool find_room(std::size_t count);
  void replace_visible(Site apex);
  void free_visible(std::size_t left);

  std::span<const Point3> points_;
  Facets& facets_;
  bool by_four_;  ///< see kernel/hull_lanes and kernel/hull_cone_lanes
  Range own_;
  /// Lives, but not while helpers insert, and is in the range or was put up by this one; kNone if
  /// there is none.
  FacetIndex last_ = 0;
  std::vector<Ridge> free_;       ///< of facets that died or were never used; the last are next
  std::size_t marked_free_ = 0;   ///< so many, the first, are marked as dead
  std::vector<FacetRoom> rooms_;  ///< where more come from
  /// Per group, a facet that was put up at one of its sites; it may be gone or another one since.
  /// Barred or not. Empty if there are no helpers.
  std::span<FacetIndex> known_;
  /// Facets outside of the range that points see which could not go in; the latest that one was
  /// found to see are last. They live as long as the range stays.
  std::vector<FacetIndex> beyond_;
  Region region_;  ///< of the insertion under way
  Cone cone_;
};

}  // namespace tetsculpt::hull
