#include "io/io_error.h"

#include <string>

namespace tetsculpt {
namespace {

std::string message(const std::filesystem::path& path, FilePlace place, std::string_view reason) {
  std::string text = path.string();
  if (const auto* line = std::get_if<LineNumber>(&place)) {
    text.append(":").append(std::to_string(line->value));
  } else if (const auto* byte = std::get_if<ByteOffset>(&place)) {
    text.append(": byte ").append(std::to_string(byte->value));
  }
  return text.append(": ").append(reason);
}

}  // namespace

IoError::IoError(const std::filesystem::path& path, std::string_view reason)
    : IoError(path, FilePlace{}, reason) {}

IoError::IoError(const std::filesystem::path& path, FilePlace place, std::string_view reason)
    : std::runtime_error(message(path, place, reason)), path_(path), place_(place) {}

std::optional<std::uint64_t> IoError::line() const {
  if (const auto* line = std::get_if<LineNumber>(&place_)) return line->value;
  return std::nullopt;
}

std::optional<std::uint64_t> IoError::byte() const {
  if (const auto* byte = std::get_if<ByteOffset>(&place_)) return byte->value;
  return std::nullopt;
}

}  // namespace tetsculpt
