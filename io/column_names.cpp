#include "io/column_names.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace tetsculpt {
namespace {

using Alias = std::pair<std::string_view, std::string_view>;

constexpr std::array<Alias, 17> kAliases = {{
    {"x", "x"},
    {"y", "y"},
    {"z", "z"},
    {"red", "red"},
    {"green", "green"},
    {"blue", "blue"},
    {"alpha", "alpha"},
    {"intensity", "intensity"},
    {"nx", "nx"},
    {"ny", "ny"},
    {"nz", "nz"},
    {"normal_x", "nx"},
    {"normal_y", "ny"},
    {"normal_z", "nz"},
    {"normalx", "nx"},
    {"normaly", "ny"},
    {"normalz", "nz"},
}};

// Too short to be taken at their word unless they come together.
constexpr std::array<Alias, 5> kLetters = {
    {{"r", "red"}, {"g", "green"}, {"b", "blue"}, {"a", "alpha"}, {"i", "intensity"}}};
constexpr std::array<Alias, 5> kFloatLetters = {
    {{"rf", "red"}, {"gf", "green"}, {"bf", "blue"}, {"af", "alpha"}, {"i", "intensity"}}};

std::string lowercase(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

template <std::size_t kSize>
void replace(std::vector<std::string>& names, const std::array<Alias, kSize>& aliases) {
  for (std::string& name : names) {
    const auto found = std::ranges::find(aliases, lowercase(name), &Alias::first);
    if (found != aliases.end()) name = found->second;
  }
}

bool has_colours(const std::vector<std::string>& names, const std::array<Alias, 5>& letters) {
  return std::all_of(letters.begin(), letters.begin() + 3, [&](const Alias& letter) {
    return std::ranges::find(names, letter.first, lowercase) != names.end();
  });
}

}  // namespace

std::vector<std::string> canonical_names(std::vector<std::string> names) {
  replace(names, kAliases);
  if (has_colours(names, kLetters)) {
    replace(names, kLetters);
  } else if (has_colours(names, kFloatLetters)) {
    replace(names, kFloatLetters);
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty()) names[i] = "scalar_" + std::to_string(i + 1);
  }
  return names;
}

bool name_coordinates(const std::vector<std::string>& names) {
  return std::ranges::all_of(std::array{"x", "y", "z"}, [&names](const char* coordinate) {
    return std::ranges::count(names, coordinate) == 1;
  });
}

std::string part_name(std::string_view name, std::size_t part) {
  return std::string(name) + "_" + std::to_string(part);
}

void make_names_distinct(std::vector<Attribute>& attributes) {
  std::set<std::string> taken = {"x", "y", "z"};
  std::map<std::string, std::size_t> last_suffix;
  for (Attribute& attribute : attributes) {
    for (char& c : attribute.name) {
      if ((c >= 0 && c <= ' ') || c == '\x7f') c = '_';
    }
    const std::string name = attribute.name;
    std::size_t& suffix = last_suffix.try_emplace(name, 1).first->second;
    while (!taken.insert(attribute.name).second) {
      attribute.name = name + "_" + std::to_string(++suffix);
    }
  }
}

}  // namespace tetsculpt
