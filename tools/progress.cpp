#include "tools/progress.h"

#include <cstdio>
#include <string>

namespace tetsculpt::cli {

void Progress::operator()(std::string_view stage, double done) {
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::seconds(1);
  std::fprintf(stderr, "tetsculpt: %s, %.0f %% done\n", std::string(stage).c_str(), 100 * done);
}

}  // namespace tetsculpt::cli
