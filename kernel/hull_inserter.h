#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "kernel/hull_facets.h"
#include "kernel/hull_lanes.h"
#include "kernel/large_array.h"
#include "kernel/large_block.h"
#include "kernel/point.h"

/// Quickhull on one batch of points at a time. Internal to kernel/lifted_hull.
namespace tetsculpt::hull {

/// The sites [begin, end), which one thread may touch; the one at infinity is everybody's. Where
/// end comes before begin: those from begin and those before end.
struct SiteRange {
  Site begin = 0;
  Site end = kAtInfinity;
  bool contains(Site s) const { return Site{s - begin} < Site{end - begin} || s == kAtInfinity; }
  /// All four, without a branch on which.
  bool contains(const std::array<Site, 4>& sites) const {
    using Four = std::uint32_t __attribute__((vector_size(16)));
    using Two = std::uint64_t __attribute__((vector_size(16)));
    Four four;
    std::memcpy(&four, &sites, sizeof four);
    const auto outside = (four - begin >= end - begin) & (four != kAtInfinity);
    const Two halves = reinterpret_cast<Two>(outside);
    return (halves[0] | halves[1]) == 0;
  }
  bool all() const { return begin == 0 && end == kAtInfinity; }
};

/// A stack that is told ahead how much it may hold, and afterwards how much it does: to fill it
/// takes no more than stores.
template <class T>
class Stack {
 public:
  /// Room for n in all.
  T* room_for(std::size_t n) {
    if (n > room_.capacity()) room_.grow(room_.capacity(), std::max(n, 2 * room_.capacity()));
    return &room_[0];
  }
  /// The first n in the room are held.
  void hold(std::size_t n) { size_ = n; }
  std::size_t size() const { return size_; }
  T& operator[](std::size_t k) { return room_[k]; }
  const T& operator[](std::size_t k) const { return room_[k]; }
  const T* begin() const { return &room_[0]; }
  const T* end() const { return begin() + size_; }
  std::span<const T> held() const { return {begin(), size_}; }

 private:
  LargeBlock<T> room_;
  std::size_t size_ = 0;
};

/// Inserts points into a hull. Several may work on one hull at a time if their ranges are disjoint:
/// one replaces only facets all of whose corners are its own, and reads only those and their
/// neighbours, which it marks and links to new ones, and the finite facet behind an infinite
/// neighbour. A facet with three corners that are its own or at infinity is out of all others'
/// reach, because they would need three, too, and there is one at infinity only; so is one with two
/// corners that are its own and none at infinity.
class alignas(64) Inserter {  // two threads' don't share a cache line
 public:
  /// How many points may be in conflict sets at a time.
  static constexpr std::size_t kBatch = 2;

  /// With all sites for its range. Facet 0 lives. `by_four` where has_four_lanes(). `known`, if
  /// there will be helpers, holds a facet per site that has one, or kNone.
  Inserter(std::span<const Point3> points, Facets& facets, std::vector<FacetRoom> rooms,
           bool by_four, std::span<FacetIndex> known);
  /// Marks the facets at hand for the next insertions as dead, which must be done before anybody
  /// asks what lives. To do so with each as it is appended would sweep the nearest cache: 6 % of
  /// the hull.
  void mark_free();
  /// Marks them and gives back what was never used: nothing is inserted any more.
  void give_back();
  /// One with a range of its own that goes on from here, as this one can only by take_over(). It
  /// must look_around() before anything is inserted.
  Inserter helper(SiteRange own);
  /// Finds out which of the facets that it knows are left and its own: others' may change under its
  /// hands later. All helpers may do so at a time, while none inserts.
  void look_around();
  /// Goes on from where a helper ended.
  void take_over(const Inserter& helper);

  /// Inserts at most kBatch points, but for those that need facets outside of the range or more
  /// memory than the store has: they are added to deferred().
  void insert(std::span<const Site> batch);
  const std::vector<Site>& deferred() const { return deferred_; }

 private:
  /// A place in the batch.
  using Slot = std::uint32_t;
  /// One point's conflict with the hull: all that share a facet are its conflict set.
  struct Conflict {
    FacetIndex facet = kNone;  ///< kNone once the point is in
    double height = 0;         ///< above that facet's hyperplane, up to rounding
  };

  bool own(FacetIndex f) const;
  /// Out of line: within the waves it would cost one thread 4 %, which has no need of it.
  [[gnu::noinline]] bool all_own(std::span<const FacetIndex> facets) const;
  bool at_site(FacetIndex f, Site s) const;
  bool insert_farthest(FacetIndex seen);
  bool find_room(std::size_t count);
  // The four steps of Quickhull.
  Slot pick_apex(FacetIndex f) const;
  bool find_horizon(Site apex, FacetIndex seen);
  void forget(std::size_t visible_count);
  void meet_neighbors(std::span<const FacetIndex> wave);
  void sort_met(Site apex, const LiftedDifference& lifted_apex);
  void cut_out();
  void make_cone(Site apex);
  void set_geometry(Site apex, std::size_t corner_count);
  void reassign_conflicts();

  // See hull_locate.cpp.
  FacetIndex locate(Site q) const;
  FacetIndex walk(Site q, FacetIndex f) const;
  FacetIndex walk_on_hull(Site q, FacetIndex f) const;
  FacetIndex locate_exactly(Site q, FacetIndex from) const;
  void add_conflict(Slot k, FacetIndex f);
  void collect_orphans(Slot apex);
  template <std::size_t kStride>
  void put_up_cone(Site apex);
  template <std::size_t kStride>
  void link_cone();
  void link_large_cone();

  std::span<const Point3> points_;
  Facets& facets_;
  bool by_four_;  ///< see kernel/hull_lanes
  SiteRange own_;
  FacetIndex last_ = 0;  ///< lives, and its corners are in the range; kNone if there is none
  std::vector<FacetIndex> free_;  ///< facets that died or were never used; the last are next
  std::vector<FacetRoom> rooms_;  ///< where more come from
  /// Per site, a facet that was put up at it; it may be gone or another one since. Empty if there
  /// are no helpers.
  std::span<FacetIndex> known_;
  std::vector<Site> deferred_;
  std::span<const Site> batch_;
  std::array<Conflict, kBatch> conflicts_{};
  // Of the insertion under way:
  Stack<FacetIndex> visible_;
  Stack<FacetIndex> met_;      ///< by the wave under way, for the first time
  Stack<FacetIndex> unclear_;  ///< of them
  Stack<Ridge> cut_;  ///< between a visible facet and one that is not, seen from the former
  Stack<Slot> orphans_;
  Stack<ConeFacet> cone_;   ///< per horizon ridge
  Stack<Spoke> spokes_;     ///< per number, from the apex to the corner
  Stack<Site> spoke_ends_;  ///< the corners' sites
  /// Per site, after the one at infinity: its number among the corners of the last horizon it was
  /// on, plus the first_number_ of that, which is more than all of any before.
  LargeArray<std::uint32_t> number_of_;
  std::uint32_t first_number_ = kNone - 1000;  ///< so that nearly every hull begins anew once
  std::vector<Ridge> half_ridge_;              ///< per ordered pair of numbers
};

}  // namespace tetsculpt::hull
