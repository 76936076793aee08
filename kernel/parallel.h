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

/// Calls work(i) for each i below count on up to `threads` threads, the first the caller's: each
/// takes the next one when it is done, so that they end about together. Rethrows the exception of
/// one of those that threw.
template <class Work>
void parallel_shares(std::size_t count, std::size_t threads, Work&& work) {
  std::atomic<std::size_t> next = 0;
  parallel_each(std::min(count, threads), [&](std::size_t) {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  });
}

/// How many of up to `threads` threads, at least one, are worth their start for n items.
inline std::size_t worth_threads(std::size_t n, int threads) {
  constexpr std::size_t kWorthAThread = 4096;
  return std::clamp<std::size_t>(n / kWorthAThread, 1,
                                 static_cast<std::size_t>(std::max(threads, 1)));
}

/// Where the ranges begin in which [0, n) is cut for up to `threads` threads, and n.
inline std::vector<std::size_t> range_cuts(std::size_t n, int threads) {
  const std::size_t parts = worth_threads(n, threads);
  std::vector<std::size_t> cuts;
  for (std::size_t part = 0; part <= parts; ++part) cuts.push_back(n * part / parts);
  return cuts;
}

/// The results of work(begin, end) on each range between two cuts, in their order, each on a thread
/// of its own. Rethrows the exception of the lowest range.
template <class Work>
auto parallel_results(const std::vector<std::size_t>& cuts, Work&& work) {
  std::vector<decltype(work(cuts[0], cuts[1]))> results(cuts.size() - 1);
  parallel_each(results.size(),
                [&](std::size_t part) { results[part] = work(cuts[part], cuts[part + 1]); });
  return results;
}

/// Calls work(begin, end) on disjoint ranges that cover [0, n), on up to `threads` threads (at
/// least one, the caller's). Items must be independent, so that the result does not depend on the
/// split. Rethrows the exception of the lowest range of those thrown.
template <class Work>
void parallel_ranges(std::size_t n, int threads, Work&& work) {
  const std::vector<std::size_t> cuts = range_cuts(n, threads);
  parallel_each(cuts.size() - 1, [&](std::size_t part) { work(cuts[part], cuts[part + 1]); });
}

}  // namespace tetsculpt
