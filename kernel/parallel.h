#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

/// Loops over independent items on several threads.
namespace tetsculpt {

/// Calls work(i) for each i below count, each on a thread of its own, the first on the caller's.
/// Rethrows the exception of the lowest i of those thrown.
template <class Work>
void parallel_each(std::size_t count, Work&& work) {
  if (count == 0) return;
  std::vector<std::exception_ptr> failures(count);
  const auto run = [&](std::size_t i) {
    try {
      work(i);
    } catch (...) {
      failures[i] = std::current_exception();
    }
  };
  std::vector<std::jthread> helpers;
  for (std::size_t i = 1; i < count; ++i) helpers.emplace_back(run, i);
  run(0);
  helpers.clear();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

/// How many of up to `threads` threads, at least one, are worth their start for n items.
inline std::size_t worth_threads(std::size_t n, int threads) {
  constexpr std::size_t kWorthAThread = 4096;
  return std::clamp<std::size_t>(n / kWorthAThread, 1,
                                 static_cast<std::size_t>(std::max(threads, 1)));
}

/// Where the parts begin in which [0, n) is cut, and n.
inline std::vector<std::size_t> equal_cuts(std::size_t n, std::size_t parts) {
  std::vector<std::size_t> cuts;
  for (std::size_t part = 0; part <= parts; ++part) cuts.push_back(n * part / parts);
  return cuts;
}
/// The same for up to `threads` threads, a part for each.
inline std::vector<std::size_t> range_cuts(std::size_t n, int threads) {
  return equal_cuts(n, worth_threads(n, threads));
}
/// The same with more parts than threads, see parallel_shares().
inline std::vector<std::size_t> share_cuts(std::size_t n, int threads) {
  constexpr int kPerThread = 8;
  const int worth = static_cast<int>(worth_threads(n, threads));
  return equal_cuts(n, worth == 1 ? 1 : worth_threads(n, kPerThread * worth));
}

/// Calls work(i) for each i below count on up to `threads` threads, the first the caller's. Each
/// begins with shares of its own, in ascending order, and when it is done takes what others have
/// left, so that they end about together: what else its processor does slows a thread by a half,
/// now and then. Rethrows the exception of the lowest i of those that threw.
template <class Work>
void parallel_shares(std::size_t count, int threads, Work&& work) {
  struct alignas(64) Next {
    std::atomic<std::size_t> share;
  };
  const auto most = static_cast<std::size_t>(std::max(threads, 1));
  const std::size_t helpers = std::min(most, std::max<std::size_t>(count, 1));
  const std::vector<std::size_t> own = equal_cuts(count, helpers);
  std::vector<Next> next(helpers);
  for (std::size_t t = 0; t < helpers; ++t) next[t].share = own[t];
  std::vector<std::exception_ptr> failures(count);
  parallel_each(helpers, [&](std::size_t first) {
    for (std::size_t k = 0; k < helpers; ++k) {
      const std::size_t t = (first + k) % helpers;
      for (std::size_t i = next[t].share++; i < own[t + 1]; i = next[t].share++) {
        try {
          work(i);
        } catch (...) {
          failures[i] = std::current_exception();
        }
      }
    }
  });
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

/// The results of work(begin, end) on each part between two cuts, in their order, on up to
/// `threads` threads. Rethrows the exception of the lowest of those that threw.
template <class Work>
auto parallel_results(const std::vector<std::size_t>& cuts, int threads, Work&& work) {
  std::vector<decltype(work(cuts[0], cuts[1]))> results(cuts.size() - 1);
  parallel_shares(results.size(), threads,
                  [&](std::size_t part) { results[part] = work(cuts[part], cuts[part + 1]); });
  return results;
}

/// Calls work(begin, end) on disjoint ranges that cover [0, n), on up to `threads` threads (at
/// least one, the caller's). Items must be independent, so that the result does not depend on the
/// split. Rethrows the exception of the lowest range of those thrown.
template <class Work>
void parallel_ranges(std::size_t n, int threads, Work&& work) {
  const std::vector<std::size_t> cuts = share_cuts(n, threads);
  parallel_shares(cuts.size() - 1, threads,
                  [&](std::size_t part) { work(cuts[part], cuts[part + 1]); });
}

}  // namespace tetsculpt
