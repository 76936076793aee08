#pragma once

/// Ctrl-C.
namespace tetsculpt::cli {

/// From now on SIGINT, SIGTERM and SIGHUP end the program at once, whatever it is doing, by the
/// same signal (a shell reports 128 + its number), after the temporary files are removed. A signal
/// that was ignored, as under nohup, stays so.
void leave_nothing_when_interrupted();

}  // namespace tetsculpt::cli
