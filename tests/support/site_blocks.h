#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/hull_sites.h"

namespace tetsculpt::hull_regions {

/// Blocks that hold a range of sites.
class SiteBlocks {
 public:
  /// None of them.
  explicit SiteBlocks(std::size_t site_count) : own_((site_count - 1) / hull::kBlock + 2) {
    own_.front() = 1;
  }
  std::size_t count() const { return own_.size() - 1; }
  void take(std::size_t block) { own_[block + 1] = 1; }
  /// Valid until this one goes.
  hull::SiteRange range() const { return hull::SiteRange(own_); }

 private:
  std::vector<std::uint8_t> own_;
};

/// Those in which a site of [begin, end) is.
inline SiteBlocks blocks_of(std::size_t site_count, hull::Site begin, hull::Site end) {
  SiteBlocks blocks(site_count);
  for (hull::Site s = begin; s < end; ++s) blocks.take(s / hull::kBlock);
  return blocks;
}

}  // namespace tetsculpt::hull_regions
