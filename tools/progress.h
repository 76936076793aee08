#pragma once

#include <chrono>
#include <string_view>

/// Progress on stderr, for work that takes over a second.
namespace tetsculpt::cli {

class Progress {
 public:
  /// Prints one line a second at most, the first after the work has taken a second.
  void operator()(std::string_view stage, double done);

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point next_ = Clock::now() + std::chrono::seconds(1);
};

}  // namespace tetsculpt::cli
