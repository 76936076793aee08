#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "kernel/hull_facets.h"
#include "kernel/hull_inserter.h"

/// Several threads on one hull. Internal to kernel/lifted_hull.
namespace tetsculpt::hull {

/// Each thread inserts the sites of a range of its own, as far as it needs no facet that is
/// another's. Which ones go in depends on how fast threads are; the hull of them all does not.
class Stretches {
 public:
  /// Told how many sites were taken, in or not, at least; on the caller's thread. May throw: that
  /// is what the caller gets, as soon as threads are done with what is not worth sharing.
  using Told = std::function<void(std::size_t)>;

  /// Goes on from where `inserter` is, which until end() must not be used. Two threads or more.
  Stretches(Facets& facets, Inserter& inserter, std::size_t site_count, std::size_t threads);
  /// Inserts sites, which are in ascending order, in passes whose ranges have other borders each
  /// time, as long as that brings something. What is left comes back.
  std::vector<Site> insert(std::vector<Site> sites, const Told& told);
  /// Lets the inserter go on from here.
  void end();

 private:
  bool worth_sharing(std::size_t count) const;
  std::vector<SiteRange> next_ranges();
  std::vector<SiteRange> even_ranges(std::span<const Site> sites) const;
  std::vector<std::vector<Site>> move_to(const std::vector<SiteRange>& ranges,
                                         std::span<const Site> sites);
  std::vector<Site> pass(std::span<const Site> sites, const Told& told);

  Facets& facets_;
  Inserter& inserter_;
  std::size_t site_count_;
  std::vector<Inserter> helpers_;  ///< one per thread
  std::size_t moves_ = 0;          ///< calls of next_ranges()
  std::size_t untried_ = 0;  ///< sites that the last pass left so; they come first in the next one
};

}  // namespace tetsculpt::hull
