#pragma once

#include <span>

namespace tetsculpt::cli {

/// `tetsculpt check`: judges a mesh file. `words` are those behind `check`. Returns the exit
/// status; its --help tells them.
int check(std::span<const char* const> words);

}  // namespace tetsculpt::cli
