#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>

namespace tetsculpt {

/// The bytes of one file.
struct FileContent {
  std::unique_ptr<char[]> bytes;
  std::size_t size = 0;

  std::string_view view() const { return {bytes.get(), size}; }
};

/// Reads all of `path` into memory, a regular file in one read; pipes are read to their end.
/// Throws IoError if it is missing, unreadable or a directory.
FileContent read_file(const std::filesystem::path& path);

/// Reads standard input to its end. Throws IoError, with "standard input" for a path.
FileContent read_standard_input();

}  // namespace tetsculpt
