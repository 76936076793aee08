#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// What the command says, and its exit statuses.
namespace tetsculpt::cli {

enum ExitStatus {
  kDone = 0,
  kUsage = 1,
  kBadInput = 2,
  kNoSolid = 3,
  kHidden = 4,
  kNoOutput = 5,
  kFaulty = 6,  ///< `check`: the mesh was read and has faults
};

/// Says it on stderr; returns `status`.
int fail(ExitStatus status, const std::string& message);

/// Puts text on stdout, and sees it through: kDone or, if it could not be written, kNoOutput.
int print(const std::string& text);

/// "1 point", "2 points", "2 vertices".
std::string counted(std::size_t n, std::string_view noun);

}  // namespace tetsculpt::cli
