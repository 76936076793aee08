#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "kernel/hull_facets.h"
#include "kernel/hull_inserter.h"
#include "kernel/hull_site_set.h"

/// Several threads on one hull. Internal to kernel/lifted_hull.
namespace tetsculpt::hull {

/// Each thread inserts the sites of a range of its own, as far as it needs no facet that is
/// another's. Which ones go in depends on how fast threads are; the hull of them all does not.
class Stretches {
 public:
  /// Told how many sites are in, or more; on the caller's thread. May throw: that is what the
  /// caller gets, as soon as threads are done with what is not worth sharing.
  using Told = std::function<void(std::size_t)>;

  Stretches(Facets& facets, Inserter& inserter, std::size_t site_count);
  /// Inserts sites on two threads or more, from where the inserter is and in passes whose ranges
  /// have other borders each time, as long as that brings something; the inserter goes on from
  /// there. What is left stays.
  void insert(SiteSet& sites, std::size_t threads, const Told& told);

 private:
  /// Sites [begin, end).
  struct Piece {
    Site begin, end;
  };
  /// A thread's part of a pass: a range in pieces, in the order in which it takes them.
  struct Share {
    SiteRange range;
    std::vector<Piece> pieces;
  };

  bool worth_sharing(std::size_t count) const;
  std::size_t cells() const;
  Site cut(std::size_t slice) const;
  Share share_of(const std::array<std::size_t, 4>& cells) const;
  std::vector<Share> next_shares();
  void pass(SiteSet& sites, const Told& told);

  Facets& facets_;
  Inserter& inserter_;
  std::size_t site_count_;
  std::size_t threads_ = 0;
  std::size_t slices_ = 1;         ///< per cell
  std::vector<Inserter> helpers_;  ///< one per thread
  std::size_t passes_ = 0;         ///< of this insert()
};

}  // namespace tetsculpt::hull
