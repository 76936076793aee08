#pragma once

#include <algorithm>
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

}  // namespace tetsculpt::testing
