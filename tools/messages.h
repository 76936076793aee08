#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

/// How the command ends, and what it says then.
namespace tetsculpt::cli {

enum ExitStatus {
  kDone = 0,
  kUsage = 1,
  kBadInput = 2,
  kNoSolid = 3,
  kHidden = 4,
  kNoOutput = 5,
  kFaulty = 6,
};

/// A status and its meaning, for the help and the manual.
struct StatusMeaning {
  int status;
  std::string_view meaning;
};
std::span<const StatusMeaning> status_meanings();

/// Says on stderr what went wrong; returns the status.
int fail(ExitStatus status, const std::string& message);

/// Puts text on stdout, and sees it through: kDone or kNoOutput.
int print(const std::string& text);

/// "1 point", "2 points", "2 vertices".
std::string counted(std::size_t n, std::string_view noun);

}  // namespace tetsculpt::cli
