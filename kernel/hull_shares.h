#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "kernel/hull_facets.h"
#include "kernel/hull_inserter.h"
#include "kernel/hull_sites.h"
#include "kernel/point.h"

/// Several threads on one hull. Internal to kernel/lifted_hull.
namespace tetsculpt::hull {

/// Each thread inserts the sites of a range of its own, as far as it needs no facet that is
/// another's. Which ones go in depends on how fast threads are; the hull of them all does not.
class Shares {
 public:
  /// Told how many sites were taken, in or not, at least; on the caller's thread. May throw: that
  /// is what the caller gets, as soon as threads are done with what is not worth sharing.
  using Told = std::function<void(std::size_t)>;

  Shares(std::span<const Point3> points, Facets& facets, Inserter& inserter);
  /// Inserts sites on two threads or more, from where the inserter is and in passes whose ranges
  /// have other borders each time, as long as that brings something; the inserter goes on from
  /// there. What is left stays.
  void insert(SiteSet& sites, std::size_t threads, const Told& told);

 private:
  static constexpr std::size_t kAxes = 3;
  /// A block and a point of it.
  struct Block {
    std::uint32_t index;
    std::array<double, kAxes> at;
  };

  void set_blocks();
  bool worth_sharing(std::size_t count) const;
  bool failing_from(std::size_t turn) const;
  void assign(std::span<Block> blocks, std::size_t first, std::size_t threads, std::size_t turn,
              const SiteSet& sites);
  std::size_t pass(SiteSet& sites, const Told& told);

  std::span<const Point3> points_;
  Facets& facets_;
  Inserter& inserter_;
  std::vector<Inserter> helpers_;                 ///< one per thread
  std::vector<Block> blocks_;                     ///< in any order
  std::array<std::size_t, kAxes> axes_{0, 1, 2};  ///< in the order of cuts
  std::vector<std::vector<std::uint8_t>> own_;    ///< per thread and block, see SiteRange
  std::size_t passes_ = 0;                        ///< that are done, of this insert()
  std::array<bool, kAxes> failing_{};             ///< whether little went in at a turn, last time
};

}  // namespace tetsculpt::hull
