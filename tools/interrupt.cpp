// All is done in the handler: nothing but temporary files outlives the process, and removing them
// is safe there. Polling a flag would leave a wait of unknown length: for a pipe, a full disk, a
// long stage.
#include "tools/interrupt.h"

#include <unistd.h>

#include <csignal>
#include <cstring>

#include "io/atomic_file.h"

namespace tetsculpt::cli {
namespace {

/// A terminal shows ^C, and perhaps a line of progress: this starts a new one.
const char* interrupted = "tetsculpt: interrupted\n";

void stop(int signal) {
  remove_temporary_files();
  [[maybe_unused]] const auto written =
      ::write(STDERR_FILENO, interrupted, std::strlen(interrupted));
  std::raise(signal);  // the handler is gone: this ends the program
}

}  // namespace

void leave_nothing_when_interrupted() {
  if (isatty(STDERR_FILENO) == 1) interrupted = "\ntetsculpt: interrupted\n";
  struct sigaction action {};
  action.sa_handler = stop;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction old {};
    sigaction(signal, nullptr, &old);
    if (old.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
  // A write to a closed pipe, or beyond a limit of size, is to fail, not to end the program.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace tetsculpt::cli
