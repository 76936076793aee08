#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace tetsculpt {

/// Standard output as the target of an AtomicFile.
struct StandardOutput {};

/// A file that appears whole or not at all. What is written goes to a temporary file in the same
/// directory; commit() renames it over the target. Without commit() the target stays as it was
/// and the temporary file is removed.
///   (1) A symbolic link stays; the file it points to is replaced, and keeps its permissions.
///   (2) A target that exists and is no regular file (a pipe, a device) is written directly, as
///       standard output is, which stays open: what a failure leaves there is cut off.
/// Throws IoError with the path of the target and the reason the system gives.
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& target);
  explicit AtomicFile(StandardOutput);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// The target as errors name it.
  const std::filesystem::path& name() const { return target_; }
  void write(std::string_view bytes);
  /// The last call: nothing can be written after it.
  void commit();

 private:
  class Doomed;
  friend void remove_temporary_files() noexcept;

  void open_temporary();
  void write_through(std::string_view bytes);
  [[noreturn]] void fail(std::string_view doing, int error) const;

  std::filesystem::path target_;     // as the caller named it, for messages
  std::filesystem::path final_;      // without symbolic links
  std::filesystem::path temporary_;  // empty if the target is written directly
  std::string block_;
  std::FILE* file_ = nullptr;
  Doomed* doomed_ = nullptr;  // what remove_temporary_files knows of this file
};

/// Removes the temporary files of all AtomicFiles there are, for a program that is about to end by
/// a signal and runs no destructors: of all functions of the library the only one that a signal
/// handler may call. It is for the paths of up to kMostPathBytes of up to kMostOpenFiles files at a
/// time; others stay behind. Relative paths are meant from where the program was when it made them.
void remove_temporary_files() noexcept;
inline constexpr std::size_t kMostPathBytes = 4096;
inline constexpr std::size_t kMostOpenFiles = 8;

}  // namespace tetsculpt
