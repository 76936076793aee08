#include "io/file_content.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "io/io_error.h"

namespace tetsculpt {
namespace {

constexpr std::size_t kUnknownSize = std::size_t{1} << 16;

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

// One byte more than the file has, so that the first read also meets its end.
std::size_t first_capacity(const std::filesystem::path& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return error || size == 0 ? kUnknownSize : static_cast<std::size_t>(size) + 1;
}

FileContent with_capacity(const FileContent& old, std::size_t capacity) {
  FileContent grown{std::make_unique_for_overwrite<char[]>(capacity), old.size};
  if (old.size > 0) std::memcpy(grown.bytes.get(), old.bytes.get(), old.size);
  return grown;
}

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view doing) {
  throw IoError(path, std::string(doing) + ": " + std::generic_category().message(errno));
}

FileContent read_all(std::FILE* file, std::size_t first_capacity,
                     const std::filesystem::path& path) {
  FileContent content;
  for (std::size_t capacity = first_capacity;; capacity *= 2) {
    content = with_capacity(content, capacity);
    content.size +=
        std::fread(content.bytes.get() + content.size, 1, capacity - content.size, file);
    if (std::ferror(file) != 0) fail(path, "cannot read");
    if (content.size < capacity) return content;
  }
}

}  // namespace

FileContent read_file(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw IoError(path, "is a directory");
  const std::unique_ptr<std::FILE, FileCloser> file(std::fopen(path.string().c_str(), "rb"));
  if (!file) fail(path, "cannot open");
  std::setvbuf(file.get(), nullptr, _IONBF, 0);
  return read_all(file.get(), first_capacity(path), path);
}

FileContent read_standard_input() { return read_all(stdin, kUnknownSize, "standard input"); }

}  // namespace tetsculpt
