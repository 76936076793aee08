#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "io/json_value.h"

namespace tetsculpt {

/// The JSON text of a glTF 2.0 asset, and what its members have to be. Faults are thrown as IoError
/// with the line, or in a .glb file the byte. Refers to path and content, which must outlive it.
class GltfJson {
 public:
  /// `content` is that of a .gltf or .glb file. Throws if it is none of version 2.
  GltfJson(std::string_view content, const std::filesystem::path& path);

  const JsonValue& root() const { return root_; }
  const std::filesystem::path& path() const { return path_; }
  /// The binary chunk of a .glb file, if it has one.
  std::optional<std::string_view> binary() const { return binary_; }

  /// Members of an object; each throws if it is of another kind.
  std::optional<std::uint64_t> integer_if_any(const JsonValue& object, std::string_view name) const;
  std::uint64_t integer(const JsonValue& object, std::string_view name) const;
  const std::string& text(const JsonValue& object, std::string_view name) const;
  std::span<const JsonValue> list(const JsonValue& object, std::string_view name) const;
  template <std::size_t N>
  std::optional<std::array<double, N>> numbers_if_any(const JsonValue& object,
                                                      std::string_view name) const;

  /// `index`, which stands at `from`, as that of an item of a list of the root.
  const JsonValue& item(std::string_view list, std::uint64_t index, const JsonValue& from) const;
  /// A whole number that is not negative.
  std::uint64_t integer(const JsonValue& value) const;

  [[noreturn]] void fail(const JsonValue& at, std::string_view reason) const;

 private:
  void take_chunks(std::string_view content);
  void check_asset() const;
  [[noreturn]] void fail(std::size_t offset, std::string_view reason) const;
  std::span<const double> numbers(const JsonValue& object, std::string_view name,
                                  std::span<double> to) const;

  const std::filesystem::path& path_;
  std::string_view text_;
  std::optional<std::size_t> text_at_;  // in a .glb file
  std::optional<std::string_view> binary_;
  JsonValue root_;
};

template <std::size_t N>
std::optional<std::array<double, N>> GltfJson::numbers_if_any(const JsonValue& object,
                                                              std::string_view name) const {
  std::array<double, N> result{};
  if (numbers(object, name, result).empty()) return std::nullopt;
  return result;
}

}  // namespace tetsculpt
