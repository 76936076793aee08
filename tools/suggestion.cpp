// Nearness is the optimal string alignment distance: letters put in, left out, changed, or two
// neighbours exchanged (F. J. Damerau, "A technique for computer detection and correction of
// spelling errors", Communications of the ACM 7(3), 1964).
#include "tools/suggestion.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace tetsculpt::cli {
namespace {

/// A word of so many letters may have one typo.
constexpr std::size_t kLettersPerTypo = 3;

std::size_t distance(std::string_view a, std::string_view b) {
  using Row = std::vector<std::size_t>;
  Row above(b.size() + 1);
  std::iota(above.begin(), above.end(), std::size_t{0});
  Row two_above = above;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    Row row(b.size() + 1, i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, changed});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], two_above[j - 2] + 1);
      }
    }
    two_above = std::exchange(above, std::move(row));
  }
  return above.back();
}

}  // namespace

std::string did_you_mean(std::string_view word, std::span<const std::string> known) {
  const std::string* best = nullptr;
  std::size_t least = std::max<std::size_t>(1, word.size() / kLettersPerTypo) + 1;
  for (const std::string& candidate : known) {
    const std::size_t typos = distance(word, candidate);
    if (typos >= least || typos >= candidate.size()) continue;
    least = typos;
    best = &candidate;
  }
  if (best == nullptr && word.size() > 1) {
    const auto begun = [&](const std::string& candidate) { return candidate.starts_with(word); };
    if (std::ranges::count_if(known, begun) == 1) best = &*std::ranges::find_if(known, begun);
  }
  return best == nullptr ? "" : "; did you mean " + *best + '?';
}

}  // namespace tetsculpt::cli
