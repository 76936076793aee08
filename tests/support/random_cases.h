#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

/// How much a test tries. The sanitizers slow every case tenfold, and what they look for is on the
/// paths taken, not in rare values: under them, less.
namespace tetsculpt::testing {

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TETSCULPT_SANITIZED
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define TETSCULPT_SANITIZED
#endif

#ifdef TETSCULPT_SANITIZED
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// All that are asked for, or a tenth of them.
template <typename Count>
constexpr Count random_cases(Count asked) {
  return kSanitized ? asked / 10 : asked;
}

/// The seeds 1 to `count`, or the first alone.
inline std::vector<std::uint64_t> seeds(std::uint64_t count) {
  std::vector<std::uint64_t> seeds;
  for (std::uint64_t seed = 1; seed <= (kSanitized ? 1 : count); ++seed) seeds.push_back(seed);
  return seeds;
}

/// All of them, or every fourth.
template <typename Set>
std::vector<Set> some_of(std::vector<Set> sets) {
  if (!kSanitized) return sets;
  std::vector<Set> some;
  for (std::size_t k = 0; k < sets.size(); k += 4) some.push_back(std::move(sets[k]));
  return some;
}

}  // namespace tetsculpt::testing
