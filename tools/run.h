#pragma once

#include "tools/arguments.h"

namespace tetsculpt::cli {

/// Reads points, makes their surface, writes it and reports; or reads and reports with --dry-run.
/// Returns the exit status.
int run(const Arguments& arguments);

}  // namespace tetsculpt::cli
