// What a signal handler may call removes the temporary files there are, and only them.
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "io/atomic_file.h"
#include "tests/support/io_files.h"

namespace tetsculpt {
namespace {

namespace fs = std::filesystem;
using testing::bytes_of;
using testing::TempDir;

std::ptrdiff_t files_in(const fs::path& dir) {
  return std::distance(fs::directory_iterator(dir), {});
}

/// In a process of its own: opens so many files, commits the first, and is ended by a signal whose
/// handler removes what is temporary.
void die_while_writing(const TempDir& dir, std::size_t count) {
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGTERM, [](int) {
      remove_temporary_files();
      _exit(7);
    });
    std::vector<std::unique_ptr<AtomicFile>> files;
    for (std::size_t k = 0; k < count; ++k) {
      files.push_back(std::make_unique<AtomicFile>(dir.path() / std::to_string(k)));
      files.back()->write(std::string(std::size_t{1} << 20, 'x'));
    }
    files.front()->commit();
    std::raise(SIGTERM);
    _exit(8);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 7);
}

TEST_CASE("the committed file stays, the others leave nothing") {
  for (const std::size_t count : {std::size_t{1}, std::size_t{3}, kMostOpenFiles}) {
    const TempDir dir;
    dir.file("2", "as it was");
    die_while_writing(dir, count);
    CHECK(bytes_of(dir.path() / "0").size() == std::size_t{1} << 20);
    CHECK(bytes_of(dir.path() / "2") == "as it was");
    CHECK(files_in(dir.path()) == 2);
  }
}

TEST_CASE("places are given back: any number of files one after the other") {
  const TempDir dir;
  for (std::size_t k = 0; k < 3 * kMostOpenFiles; ++k) {
    AtomicFile out(dir.path() / "a");
    out.write("x");
    if (k % 2 == 0) out.commit();
  }
  die_while_writing(dir, kMostOpenFiles);
  CHECK(files_in(dir.path()) == 2);  // "0" and "a"
}

TEST_CASE("more files than there are places are written as always") {
  const TempDir dir;
  std::vector<std::unique_ptr<AtomicFile>> files;
  for (std::size_t k = 0; k < 2 * kMostOpenFiles; ++k) {
    files.push_back(std::make_unique<AtomicFile>(dir.path() / std::to_string(k)));
  }
  for (const auto& file : files) file->commit();
  CHECK(files_in(dir.path()) == static_cast<std::ptrdiff_t>(2 * kMostOpenFiles));
}

}  // namespace
}  // namespace tetsculpt
