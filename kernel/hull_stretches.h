#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "kernel/hull_facets.h"
#include "kernel/hull_inserter.h"

/// Several threads on one hull. Internal to kernel/lifted_hull.
namespace tetsculpt::hull {

/// Each thread inserts the sites of one stretch of the curve, as far as it needs no facet that is
/// another's. Which ones go in depends on how fast threads are; the hull of them all does not.
class Stretches {
 public:
  /// Told how many sites were taken, in or not, at least; on the caller's thread. May throw: that
  /// is what the caller gets, as soon as threads are done with what is not worth sharing.
  using Told = std::function<void(std::size_t)>;

  /// Goes on from where `inserter` is, which until end() must not be used. Two threads or more.
  Stretches(Facets& facets, Inserter& inserter, std::size_t site_count, std::size_t threads);
  /// Inserts sites, which are in ascending order, in stretches that begin at the cuts, one for each
  /// thread; the last one goes on at the curve's beginning. When one stretch is done, what the
  /// others have left, if it is enough, is shared out again in stretches that begin elsewhere. What
  /// none could hold comes back in ascending order.
  std::vector<Site> insert(std::vector<Site> sites, std::vector<Site> cuts, const Told& told);
  /// Lets the inserter go on from here.
  void end();

 private:
  std::vector<Site> take_deferred();
  std::size_t along(Site s, Site from) const;
  std::vector<std::size_t> begin_in(const std::vector<Site>& sites,
                                    const std::vector<Site>& cuts) const;
  std::vector<Site> insert_until_one_is_done(const std::vector<Site>& sites,
                                             const std::vector<Site>& cuts, const Told& told);
  std::vector<Site> even_cuts(const std::vector<Site>& sites) const;

  Facets& facets_;
  Inserter& inserter_;
  std::size_t site_count_;
  std::vector<Inserter> helpers_;  ///< one per thread
};

}  // namespace tetsculpt::hull
