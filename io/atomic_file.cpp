#include "io/atomic_file.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cassert>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <random>
#include <system_error>
#include <utility>

#include "io/io_error.h"

namespace tetsculpt {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBlockSize = std::size_t{1} << 18;

fs::path without_symlink(const fs::path& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  fs::path resolved = fs::canonical(path, error);
  return error ? path : resolved;
}

// The name is independent of the target's, which may be as long as a name can be.
std::string temporary_name() {
  std::random_device random;
  const std::uint64_t tag = std::uint64_t{random()} << 32 | random();
  std::array<char, 16> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), tag, 16).ptr;
  return ".tetsculpt-" + std::string(digits.data(), end) + ".tmp";
}

}  // namespace

/// The path of a temporary file where a signal handler finds it: the handler can be given nothing,
/// so these are global. Taken before the file is made, let go of when it is gone.
class AtomicFile::Doomed {
 public:
  /// Null if the path is too long or no place is free.
  static Doomed* take(const std::string& path) {
    if (path.size() >= kMostPathBytes) return nullptr;
    for (Doomed& doomed : all) {
      State expected = State::kFree;
      if (!doomed.state_.compare_exchange_strong(expected, State::kTaken)) continue;
      path.copy(doomed.path_.data(), path.size());
      doomed.path_[path.size()] = 0;
      doomed.state_ = State::kNamed;
      return &doomed;
    }
    return nullptr;
  }
  void let_go() { state_ = State::kFree; }
  static void remove_all() noexcept {
    for (const Doomed& doomed : all) {
      if (doomed.state_ == State::kNamed) ::unlink(doomed.path_.data());
    }
  }

 private:
  enum class State : int { kFree, kTaken, kNamed };
  static_assert(std::atomic<State>::is_always_lock_free);  // a handler may load it

  static std::array<Doomed, kMostOpenFiles> all;
  std::atomic<State> state_ = State::kFree;
  std::array<char, kMostPathBytes> path_{};
};

constinit std::array<AtomicFile::Doomed, kMostOpenFiles> AtomicFile::Doomed::all{};

void remove_temporary_files() noexcept { AtomicFile::Doomed::remove_all(); }

AtomicFile::AtomicFile(const fs::path& target) : target_(target), final_(target) {
  block_.reserve(kBlockSize);
  std::error_code ignored;
  const fs::file_status status = fs::status(target, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    file_ = std::fopen(target.string().c_str(), "wb");
    if (file_ == nullptr) fail("cannot create", errno);
  } else {
    final_ = without_symlink(target);
    open_temporary();
  }
  std::setvbuf(file_, nullptr, _IONBF, 0);
}

AtomicFile::AtomicFile(StandardOutput) : target_("standard output"), file_(stdout) {
  block_.reserve(kBlockSize);
}

AtomicFile::~AtomicFile() {
  if (file_ != nullptr && file_ != stdout) std::fclose(file_);
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
  if (doomed_ != nullptr) doomed_->let_go();
}

void AtomicFile::open_temporary() {
  constexpr int kAttempts = 100;
  int error = EEXIST;
  for (int i = 0; i < kAttempts && error == EEXIST; ++i) {
    const fs::path name = final_.parent_path() / temporary_name();
    doomed_ = Doomed::take(name.string());
    file_ = std::fopen(name.string().c_str(), "wbx");  // x: must not exist
    error = file_ == nullptr ? errno : 0;
    if (file_ != nullptr) {
      temporary_ = name;
    } else if (doomed_ != nullptr) {
      std::exchange(doomed_, nullptr)->let_go();
    }
  }
  if (file_ == nullptr) fail("cannot create", error);
}

void AtomicFile::write(std::string_view bytes) {
  assert(file_ != nullptr);
  if (bytes.size() > kBlockSize - block_.size()) {
    write_through(block_);
    block_.clear();
  }
  if (bytes.size() > kBlockSize) {
    write_through(bytes);
  } else {
    block_.append(bytes);
  }
}

void AtomicFile::write_through(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) {
    fail("cannot write", errno);
  }
}

void AtomicFile::commit() {
  assert(file_ != nullptr);
  write_through(block_);
  std::FILE* const file = std::exchange(file_, nullptr);
  if ((file == stdout ? std::fflush(file) : std::fclose(file)) != 0) fail("cannot write", errno);
  if (temporary_.empty()) return;
  std::error_code error;
  if (const fs::file_status old = fs::status(final_, error); fs::is_regular_file(old)) {
    fs::permissions(temporary_, old.permissions(), error);  // as good as it goes
  }
  fs::rename(temporary_, final_, error);
  if (error) fail("cannot replace", error.value());
  temporary_.clear();
}

void AtomicFile::fail(std::string_view doing, int error) const {
  throw IoError(target_, std::string(doing) + ": " + std::generic_category().message(error));
}

}  // namespace tetsculpt
