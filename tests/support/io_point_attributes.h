#pragma once

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/point_file.h"

/// Looking at the attributes of what was read.
namespace tetsculpt::testing {

/// The names in their order, with blanks between.
inline std::string attribute_names(const PointFile& file) {
  std::string names;
  for (const Attribute& attribute : file.attributes) {
    names += (names.empty() ? "" : " ") + attribute.name;
  }
  return names;
}

/// The attribute is there and has just these values in just this type.
template <typename Value>
bool has_values(const PointFile& file, std::string_view name, const std::vector<Value>& values) {
  const auto found = std::ranges::find(file.attributes, name, &Attribute::name);
  if (found == file.attributes.end()) return false;
  const auto* const all = std::get_if<std::vector<Value>>(&found->values);
  return all != nullptr && *all == values;
}

/// Each attribute has as many values as there are points.
inline bool complete(const PointFile& file) {
  return std::ranges::all_of(file.attributes, [&file](const Attribute& attribute) {
    return std::visit([&file](const auto& values) { return values.size() == file.points.size(); },
                      attribute.values);
  });
}

/// `parse` with a look at what it gives.
template <typename Parse>
auto completely(Parse parse) {
  return [parse](std::string_view content, const std::filesystem::path& path) {
    if (!complete(parse(content, path))) throw std::logic_error("an attribute is not complete");
  };
}

}  // namespace tetsculpt::testing
