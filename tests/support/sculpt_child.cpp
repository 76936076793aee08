#include "tests/support/sculpt_child.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <utility>

namespace tetsculpt::testing {
namespace {

void check(bool good, const char* what) {
  if (!good) throw std::runtime_error(what);
}

struct Ends {
  int ours;
  int theirs;
};

Ends pipe_to_read() {
  std::array<int, 2> ends{};
  check(::pipe(ends.data()) == 0, "pipe");
  return {ends[0], ends[1]};
}

Ends terminal() {
  const int ours = ::posix_openpt(O_RDWR | O_NOCTTY);
  check(ours >= 0 && ::grantpt(ours) == 0 && ::unlockpt(ours) == 0, "terminal");
  const int theirs = ::open(::ptsname(ours), O_RDWR | O_NOCTTY);
  check(theirs >= 0, "terminal");
  return {ours, theirs};
}

}  // namespace

Child::Child(const TempDir& dir, const std::vector<std::string>& words, Stderr kind, int ignored) {
  const Ends err = kind == Stderr::kPipe ? pipe_to_read() : terminal();
  const Ends in = pipe_to_read();  // here it is the child that reads
  std::vector<const char*> arguments{TETSCULPT_CLI};
  for (const std::string& word : words) arguments.push_back(word.c_str());
  arguments.push_back(nullptr);
  pid_ = ::fork();
  check(pid_ >= 0, "fork");
  if (pid_ == 0) {
    ::setenv("TERM", "xterm", 1);
    if (ignored != 0) std::signal(ignored, SIG_IGN);
    ::dup2(in.ours, STDIN_FILENO);
    ::dup2(err.theirs, STDERR_FILENO);
    for (const int end : {in.ours, in.theirs, err.ours, err.theirs}) ::close(end);
    if (::chdir(dir.path().c_str()) == 0) {
      ::execv(TETSCULPT_CLI, const_cast<char* const*>(arguments.data()));
    }
    ::_exit(127);
  }
  ::close(err.theirs);
  ::close(in.ours);
  stderr_ = err.ours;
  in_ = in.theirs;
}

Child::~Child() {
  if (pid_ >= 0) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  close_input();
  ::close(stderr_);
}

bool Child::said(std::string_view text) {
  std::array<char, 4096> bytes;
  while (err_.find(text) == std::string::npos) {
    const ssize_t n = ::read(stderr_, bytes.data(), bytes.size());
    if (n <= 0) return false;  // the end; of a terminal, an error
    err_.append(bytes.data(), static_cast<std::size_t>(n));
  }
  return true;
}

void Child::send(int signal) const { ::kill(pid_, signal); }

void Child::close_input() {
  if (in_ >= 0) ::close(std::exchange(in_, -1));
}

int Child::wait() {
  while (said(std::string(1, '\0'))) {  // never: to the end
  }
  int status = 0;
  ::waitpid(std::exchange(pid_, -1), &status, 0);
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace tetsculpt::testing
