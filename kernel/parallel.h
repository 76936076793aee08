#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

/// Loops over independent items on several threads.
namespace tetsculpt {

/// Calls work(begin, end) on disjoint ranges that cover [0, n), on up to `threads` threads (at
/// least one, the caller's). Items must be independent, so that the result does not depend on the
/// split. Rethrows one exception of those thrown.
template <class Work>
void parallel_ranges(std::size_t n, int threads, Work&& work) {
  constexpr std::size_t kWorthAThread = 4096;
  const std::size_t parts =
      std::clamp<std::size_t>(n / kWorthAThread, 1, static_cast<std::size_t>(std::max(threads, 1)));
  if (parts == 1) {
    work(std::size_t{0}, n);
    return;
  }
  std::vector<std::exception_ptr> failures(parts);
  const auto run = [&](std::size_t part) {
    try {
      work(n * part / parts, n * (part + 1) / parts);
    } catch (...) {
      failures[part] = std::current_exception();
    }
  };
  std::vector<std::jthread> helpers;
  for (std::size_t part = 1; part < parts; ++part) helpers.emplace_back(run, part);
  run(0);
  helpers.clear();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace tetsculpt
