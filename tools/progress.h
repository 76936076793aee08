#pragma once

#include <chrono>
#include <string>
#include <string_view>

/// Progress on stderr.
namespace tetsculpt::cli {

class Progress {
 public:
  enum class When {
    kNever,
    kIfSlow,  ///< once the work has taken a second
    kAlways,  ///< from the first word on
  };
  explicit Progress(When when);

  /// Tells the stage and the share of it that is done, from 0 to 1; shows it with the share of the
  /// whole and the time left. On a terminal one line is written again and again, some times a
  /// second; elsewhere lines are some seconds apart.
  void operator()(std::string_view stage, double done);
  /// Takes back the line on a terminal.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  std::string line(std::string_view stage, double share) const;

  When when_;
  bool terminal_;
  bool line_open_ = false;
  std::string last_stage_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_;
};

}  // namespace tetsculpt::cli
