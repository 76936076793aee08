#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "kernel/hull_facets.h"

/// Which sites are still to be inserted. Internal to kernel/lifted_hull.
namespace tetsculpt::hull {

/// A bit per site. Threads may change and read parts at a time that begin and end with a word.
class SiteSet {
 public:
  /// Sites per word, the first of which is a multiple.
  static constexpr Site kPerWord = 64;

  explicit SiteSet(std::size_t site_count) : words_((site_count + kPerWord - 1) / kPerWord) {}

  void insert(Site s) { words_[s / kPerWord] |= bit(s); }
  void erase(Site s) { words_[s / kPerWord] &= ~bit(s); }
  /// How many there are in a part: [begin, end).
  std::size_t count(Site begin, Site end) const {
    const auto add = [](std::size_t sum, std::uint64_t word) {
      return sum + static_cast<std::size_t>(std::popcount(word));
    };
    return std::accumulate(words_.begin() + begin / kPerWord, words_.begin() + word_end(end),
                           std::size_t{0}, add);
  }
  std::size_t count() const { return count(0, static_cast<Site>(words_.size() * kPerWord)); }
  /// In ascending order, those in a part, until visit(s), which may erase s, returns false: then it
  /// does so, too.
  template <class Visit>
  bool each(Site begin, Site end, Visit&& visit) const {
    for (Site w = begin / kPerWord; w < word_end(end); ++w) {
      for (std::uint64_t word = words_[w]; word != 0; word &= word - 1) {
        if (!visit(w * kPerWord + static_cast<Site>(std::countr_zero(word)))) return false;
      }
    }
    return true;
  }
  /// The first site of each word in which there are any.
  template <class Visit>
  void each_word(Visit&& visit) const {
    for (Site w = 0; w < words_.size(); ++w) {
      if (words_[w] != 0) visit(w * kPerWord);
    }
  }

 private:
  static Site word_end(Site end) { return (end + kPerWord - 1) / kPerWord; }
  static std::uint64_t bit(Site s) { return std::uint64_t{1} << s % kPerWord; }

  std::vector<std::uint64_t> words_;
};

}  // namespace tetsculpt::hull
