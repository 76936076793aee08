#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <system_error>

#include "io/io_error.h"
#include "io/read_points.h"

/// Files for the tests of io.
namespace tetsculpt::testing {

/// A new directory for temporary files, removed with all it holds at the end of the scope.
class TempDir {
 public:
  TempDir() {
    std::random_device random;
    do {
      path_ = std::filesystem::temp_directory_path() /
              ("tetsculpt_test_" + std::to_string(random()) + std::to_string(random()));
    } while (!std::filesystem::create_directory(path_));
  }
  ~TempDir() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TempDir(const TempDir&) = delete;
  TempDir& operator=(const TempDir&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Makes the file `name` with this content and returns its path.
  std::filesystem::path file(std::string_view name, std::string_view content) const {
    std::filesystem::path made = path_ / name;
    std::ofstream(made, std::ios::binary)
        .write(content.data(), static_cast<std::streamsize>(content.size()));
    return made;
  }

 private:
  std::filesystem::path path_;
};

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What read_points makes of a file `name` with this content.
inline PointFile read_content(std::string_view name, std::string_view content) {
  const TempDir dir;
  return read_points(dir.file(name, content));
}

/// The place and the reason of a refusal: "3: reason", "byte 3: reason" or "reason"; "read" if
/// the file is read.
inline std::string refusal(std::string_view name, std::string_view content) {
  const TempDir dir;
  const std::filesystem::path path = dir.file(name, content);
  try {
    read_points(path);
  } catch (const IoError& error) {
    const std::string_view message = error.what();
    return std::string(message.substr(path.string().size() + (error.line() ? 1 : 2)));
  }
  return "read";
}

}  // namespace tetsculpt::testing
