#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "kernel/hull_facets.h"
#include "kernel/hull_inserter.h"
#include "kernel/hull_range.h"
#include "kernel/hull_sites.h"
#include "kernel/point.h"

/// Several threads on one hull. Internal to kernel/lifted_hull.
namespace tetsculpt::hull {

/// Each thread inserts the sites of a range of its own, as far as it needs no facet that is
/// another's: by the facets' corners first, then by their centers. Which ones go in depends on how
/// fast threads are; the hull of them all does not.
class Shares {
 public:
  /// Told how many sites were taken, in or not, at least; on the caller's thread. May throw: that
  /// is what the caller gets, as soon as threads are done with what is not worth sharing.
  using Told = std::function<void(std::size_t)>;

  /// `threads`: for its own preparations.
  Shares(std::span<const Point3> points, Facets& facets, Inserter& inserter, int threads);
  /// Inserts sites on two threads or more, from where the inserter is and in passes whose ranges
  /// have other borders each time, as long as that brings something, and the rest with the
  /// inserter. None is left.
  void insert(SiteSet& sites, std::size_t threads, const Told& told);

 private:
  static constexpr std::size_t kAxes = 3;

  bool worth_sharing(std::size_t count) const;
  bool failing_from(std::size_t pass) const;
  std::size_t pass_by_corners(SiteSet& sites, std::size_t left, const Told& told);
  std::size_t pass_by_centers(SiteSet& sites, std::size_t left, const Told& told);
  /// Cuts across these axes, this one of them first, by where blocks are.
  struct Cuts {
    const std::vector<Position>& at;
    std::array<std::size_t, kAxes> axes;
    std::size_t first;
  };
  /// How a thread's part of space is its range.
  using RangeOf = std::function<Range(const SiteRange&, const Position& low, const Position& high)>;
  Inserter::Tally pass(SiteSet& sites, std::size_t left, const Cuts& cuts, const RangeOf& range_of,
                       const Told& told);

  std::vector<Position> at_;  ///< a point of each block
  Facets& facets_;
  Inserter& inserter_;
  std::array<std::size_t, kAxes> axes_{0, 1, 2};  ///< along the longest side of all sites first
  std::vector<Inserter> helpers_;                 ///< one per thread
  std::vector<std::vector<std::uint8_t>> own_;    ///< per thread and block, see SiteRange
  std::array<bool, kAxes> failing_{};             ///< whether little went in in a pass, last time
};

}  // namespace tetsculpt::hull
