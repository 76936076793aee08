#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "kernel/hull_facets.h"

/// Which sites are whose, and which are still to be inserted. Internal to kernel/lifted_hull.
namespace tetsculpt::hull {

/// So many sites one behind the other are one thread's.
inline constexpr Site kBlock = 16;

/// The sites that one thread may touch: blocks, and the one at infinity, which is everybody's.
class SiteRange {
 public:
  /// All of them.
  SiteRange() = default;
  /// Those of the blocks for which there is a one; for others there is a zero. Ahead of the first
  /// block comes a one, for the site at infinity.
  explicit SiteRange(std::span<const std::uint8_t> blocks) : blocks_(blocks.data() + 1) {}

  bool all() const { return blocks_ == nullptr; }
  bool contains(Site s) const { return all() || at(s) != 0; }
  /// All four corners of a facet that lives, without a branch on which.
  bool contains(const std::array<Site, 4>& sites) const {
    const auto [a, b, c, d] = sites;
    return all() || (at(a) & at(b) & at(c) & at(d)) != 0;
  }

 private:
  /// Infinity is -1. Of other sites there are fewer than 2^31, see kernel/distinct_points.
  std::uint8_t at(Site s) const {
    return blocks_[static_cast<std::int32_t>(s) >> std::countr_zero(kBlock)];
  }

  const std::uint8_t* blocks_ = nullptr;
};

/// A bit per site. Threads may change and read blocks of their own at a time.
class SiteSet {
 public:
  explicit SiteSet(std::size_t site_count) : words_((site_count + kBlock - 1) / kBlock) {}

  std::size_t block_count() const { return words_.size(); }
  void insert(Site s) { words_[s / kBlock] = static_cast<Word>(words_[s / kBlock] | bit(s)); }
  void erase(Site s) { words_[s / kBlock] = static_cast<Word>(words_[s / kBlock] & ~bit(s)); }
  std::size_t count_in(std::size_t block) const {
    return static_cast<std::size_t>(std::popcount(words_[block]));
  }
  std::size_t count() const {
    const auto add = [](std::size_t sum, Word word) {
      return sum + static_cast<std::size_t>(std::popcount(word));
    };
    return std::accumulate(words_.begin(), words_.end(), std::size_t{0}, add);
  }
  /// In ascending order, those of a block, until visit(s), which may erase s, returns false: then
  /// it does so, too.
  template <class Visit>
  bool each_in(std::size_t block, Visit&& visit) const {
    const Site first = static_cast<Site>(block) * kBlock;
    for (std::uint32_t word = words_[block]; word != 0; word &= word - 1) {
      if (!visit(first + static_cast<Site>(std::countr_zero(word)))) return false;
    }
    return true;
  }

 private:
  using Word = std::uint16_t;
  static_assert(8 * sizeof(Word) == kBlock);
  static std::uint32_t bit(Site s) { return std::uint32_t{1} << s % kBlock; }

  std::vector<Word> words_;
};

}  // namespace tetsculpt::hull
