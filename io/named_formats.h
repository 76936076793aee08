#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "io/extension.h"

namespace tetsculpt {

/// Formats with their names: extensions without the dot, in lower case. A format may have several.
template <class Format, std::size_t N>
struct NamedFormats {
  std::array<std::pair<std::string_view, Format>, N> table;

  std::optional<Format> named(std::string_view name) const {
    for (const auto& [known, format] : table) {
      if (name == known) return format;
    }
    return std::nullopt;
  }
  /// The one that the extension of `path` names, in either case.
  std::optional<Format> of(const std::filesystem::path& path) const {
    const std::string extension = lowercase_extension(path);
    if (extension.empty()) return std::nullopt;
    return named(std::string_view(extension).substr(1));
  }
  /// The first name of a format. Precondition: it has one.
  std::string_view name(Format format) const {
    std::size_t i = 0;
    while (table[i].second != format) ++i;
    return table[i].first;
  }
  /// All names, in the order of the table, with dots and blanks between.
  std::string extensions() const {
    std::string all;
    for (const auto& [name, format] : table) {
      all.append(all.empty() ? "." : " .").append(name);
    }
    return all;
  }
};

}  // namespace tetsculpt
