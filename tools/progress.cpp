#include "tools/progress.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace tetsculpt::cli {
namespace {

using namespace std::chrono_literals;

constexpr auto kQuick = 1s;  ///< what takes no longer needs no progress
constexpr auto kOnTerminal = 100ms;
constexpr auto kElsewhere = 4s;

/// What a stage takes of the whole, about: between scans, where sculpting takes longest, and clean
/// surfaces.
struct Stage {
  std::string_view name;
  double begin;
  double end;
};
constexpr std::array<Stage, 5> kStages{{{"read", 0, 0.05},
                                        {"delaunay", 0.05, 0.5},
                                        {"graphs", 0.5, 0.58},
                                        {"sculpt", 0.58, 0.96},
                                        {"write", 0.96, 1}}};

double share_of_whole(std::string_view stage, double done) {
  const auto it = std::ranges::find(kStages, stage, &Stage::name);
  if (it == kStages.end()) return done;
  return it->begin + (it->end - it->begin) * std::clamp(done, 0.0, 1.0);
}

/// A terminal that can rewrite a line.
bool is_terminal() {
  const char* kind = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && kind != nullptr && std::string_view(kind) != "dumb";
}

}  // namespace

Progress::Progress(When when)
    : when_(when),
      terminal_(is_terminal()),
      next_(when == When::kAlways ? start_ : start_ + kQuick) {}

void Progress::clear() {
  if (line_open_) std::fputs("\r\x1b[K", stderr);
  line_open_ = false;
}

void Progress::operator()(std::string_view stage, double done) {
  const Clock::time_point now = Clock::now();
  const bool new_stage = when_ == When::kAlways && stage != last_stage_;
  if (when_ == When::kNever || (now < next_ && !new_stage)) return;
  last_stage_ = stage;
  next_ = now + (terminal_ ? Clock::duration(kOnTerminal) : Clock::duration(kElsewhere));
  const std::string text = line(stage, share_of_whole(stage, done));
  std::fprintf(stderr, terminal_ ? "\r%s\x1b[K" : "%s\n", text.c_str());
  line_open_ = terminal_;
}

std::string Progress::line(std::string_view stage, double share) const {
  constexpr double kEnoughToTell = 0.1;
  std::array<char, 64> numbers{};
  std::snprintf(numbers.data(), numbers.size(), ", %.0f %% done", 100 * share);
  std::string text = "tetsculpt: " + std::string(stage) + numbers.data();
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  if (share < kEnoughToTell || seconds < 1) return text;
  const double left = std::ceil(seconds / share * (1 - share));
  std::snprintf(numbers.data(), numbers.size(), ", about %.0f %s left",
                left < 100 ? left : left / 60, left < 100 ? "s" : "min");
  return text + numbers.data();
}

}  // namespace tetsculpt::cli
