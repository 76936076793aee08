#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/hull_facets.h"
#include "kernel/large_array.h"
#include "kernel/point.h"

/// Quickhull on one batch of points at a time. Internal to kernel/lifted_hull.
namespace tetsculpt::hull {

/// The sites [begin, end), which one thread may touch; the one at infinity is everybody's.
struct SiteRange {
  Site begin = 0;
  Site end = kAtInfinity;
  bool contains(Site s) const { return (s >= begin && s < end) || s == kAtInfinity; }
  bool all() const { return begin == 0 && end == kAtInfinity; }
};

/// Inserts points into a hull. Several may work on one hull at a time if their ranges are disjoint:
/// one changes only facets all of whose corners are its own, and reads only those and their
/// neighbours. A facet with three corners that are its own or at infinity is out of all others'
/// reach, because they would need three, too, and there is one at infinity only.
class Inserter {
 public:
  /// How many points may be in conflict sets at a time.
  static constexpr std::size_t kBatch = 16;

  /// With all sites for its range. Facet 0 lives.
  Inserter(std::span<const Point3> points, Facets& facets);
  /// One with a range of its own that goes on from here, as this one can only by take_over().
  Inserter helper(SiteRange own);
  /// Goes on from where a helper ended.
  void take_over(const Inserter& helper);

  /// Inserts at most kBatch points, but for those that need facets outside of the range or more
  /// memory than the store has: they are added to deferred().
  void insert(std::span<const Site> batch);
  const std::vector<Site>& deferred() const { return deferred_; }
  /// Facets that died without a successor.
  const std::vector<FacetIndex>& free() const { return free_; }

 private:
  /// A place in the batch.
  using Slot = std::uint32_t;
  /// One point's conflict with the hull.
  struct Conflict {
    FacetIndex facet = kNone;  ///< whose set holds the point; kNone once it is in
    Slot next = kNone;         ///< the next point of that set
    double height = 0;         ///< above that facet's hyperplane, up to rounding
  };
  /// A ridge between a visible facet and one that is not, as the cone's new facet will hold it.
  struct HorizonRidge {
    std::array<Site, 3> corners;  ///< with the apex first, these make a positively oriented facet
    Ridge outer;                  ///< seen from the facet that stays
  };

  bool own(FacetIndex f) const;
  bool insert_farthest(FacetIndex seen);
  // The four steps of Quickhull.
  Slot pick_apex(FacetIndex f) { return facets_.farthest(f); }
  bool find_horizon(Site apex, FacetIndex seen);
  void make_visible(FacetIndex f, Ridge through);
  void make_cone(Site apex);
  void reassign_conflicts();

  FacetIndex locate(Site q) const;
  FacetIndex locate_exactly(Site q, FacetIndex from) const;
  void add_conflict(Slot k, FacetIndex f);
  void collect_orphans(Slot apex);
  std::uint32_t number_of(Site s, Site apex);
  void link_cone();
  void link_large_cone();

  std::span<const Point3> points_;
  Facets& facets_;
  SiteRange own_;
  FacetIndex last_ = 0;  ///< lives, and its corners are in the range; kNone if there is none
  std::uint32_t stamp_ = 0;
  std::vector<FacetIndex> free_;
  std::vector<Site> deferred_;
  std::span<const Site> batch_;
  std::array<Conflict, kBatch> conflicts_{};
  // Of the insertion under way:
  std::vector<FacetIndex> visible_;
  struct FrontRidge {
    Ridge inner;  ///< seen from a visible facet
    Ridge outer;  ///< the same, seen from the other side
  };
  std::vector<FrontRidge> front_;
  std::vector<HorizonRidge> horizon_;
  std::vector<Slot> orphans_;
  std::vector<FacetIndex> cone_;                     ///< new facet per horizon ridge
  std::vector<std::array<std::uint32_t, 3>> local_;  ///< its corners' numbers among the horizon's
  std::vector<Spoke> spokes_;                        ///< per number, from the apex to the corner
  std::uint32_t infinite_number_ = kNone;
  struct Number {
    std::uint32_t stamp;  ///< of the insertion in which it counts
    std::uint32_t number;
  };
  LargeArray<Number> number_of_;   ///< per site of the range and, last, the one at infinity
  std::vector<Ridge> half_ridge_;  ///< per ordered pair of numbers
};

}  // namespace tetsculpt::hull
