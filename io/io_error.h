#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <variant>

namespace tetsculpt {

/// Counted from 1.
struct LineNumber {
  std::uint64_t value;
};

/// Counted from 0.
struct ByteOffset {
  std::uint64_t value;
};

/// Where in a file; std::monostate is the file as a whole.
using FilePlace = std::variant<std::monostate, LineNumber, ByteOffset>;

/// A file that cannot be read or written, with the place of the fault. what() is one of
/// `path: reason`, `path:line: reason`, `path: byte N: reason`.
class IoError : public std::runtime_error {
 public:
  IoError(const std::filesystem::path& path, std::string_view reason);
  IoError(const std::filesystem::path& path, FilePlace place, std::string_view reason);

  const std::filesystem::path& path() const { return path_; }
  std::optional<std::uint64_t> line() const;
  std::optional<std::uint64_t> byte() const;

 private:
  std::filesystem::path path_;
  FilePlace place_;
};

}  // namespace tetsculpt
