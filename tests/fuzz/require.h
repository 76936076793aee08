#pragma once

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

namespace tetsculpt::fuzz {

/// Ends the run as a finding unless it holds.
inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "finding: %s\n", what);
  std::abort();
}

inline void require_none(const std::optional<std::string>& broken) {
  require(!broken, broken ? broken->c_str() : "");
}

}  // namespace tetsculpt::fuzz
