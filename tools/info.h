#pragma once

#include <span>

namespace tetsculpt::cli {

/// `tetsculpt info`: describes a file of points. `words` are those behind `info`. Returns the exit
/// status; its --help tells them.
int info(std::span<const char* const> words);

}  // namespace tetsculpt::cli
