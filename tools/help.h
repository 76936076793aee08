#pragma once

#include <string>

/// The texts that teach the command, drawn from the table of tools/options.h.
namespace tetsculpt::cli {

/// The text of --help, 80 columns wide.
std::string help();

/// The manual page, in the man macros of troff.
std::string manual();

/// The completion script for bash.
std::string bash_completion();

}  // namespace tetsculpt::cli
