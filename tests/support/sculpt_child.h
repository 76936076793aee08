#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>
#include <vector>

#include "tests/support/io_files.h"

/// A run of the program that can be watched and sent signals. Needs TETSCULPT_CLI, its path.
namespace tetsculpt::testing {

class Child {
 public:
  enum class Stderr { kPipe, kTerminal };
  /// Starts it in `dir`, with a pipe for its input; `ignored` is a signal that it is to ignore, 0:
  /// none.
  Child(const TempDir& dir, const std::vector<std::string>& words, Stderr kind = Stderr::kPipe,
        int ignored = 0);
  /// Kills it if it still runs.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Waits until it has said this on stderr, or says no more. True if it has.
  bool said(std::string_view text);
  /// All it said so far.
  const std::string& err() const { return err_; }
  void send(int signal) const;
  void close_input();
  /// Waits for its end. Its exit status, or 128 + the signal that ended it.
  int wait();

 private:
  pid_t pid_ = -1;
  int in_ = -1;
  int stderr_ = -1;
  std::string err_;
};

}  // namespace tetsculpt::testing
