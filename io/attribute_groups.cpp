#include "io/attribute_groups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <variant>

namespace tetsculpt {
namespace {

template <typename Type>
bool holds(const Attribute& attribute) {
  return std::holds_alternative<std::vector<Type>>(attribute.values);
}

bool finite_floats(const Attribute& attribute) {
  return std::visit(
      []<typename Value>(const std::vector<Value>& values) {
        if constexpr (std::is_floating_point_v<Value>) {
          return std::ranges::all_of(values, [](Value v) { return std::isfinite(v); });
        } else {
          return false;
        }
      },
      attribute.values);
}

bool can_be_colour(const Attribute& attribute) {
  return holds<std::uint8_t>(attribute) || holds<std::uint16_t>(attribute) ||
         finite_floats(attribute);
}

// The first attribute of each name, all of one type that `suits`; empty if one is missing.
template <typename Suits>
AttributeRefs of_one_type(std::span<const Attribute> attributes,
                          std::span<const std::string_view> names, const Suits& suits) {
  AttributeRefs found;
  for (const std::string_view name : names) {
    const auto it = std::ranges::find(attributes, name, &Attribute::name);
    if (it == attributes.end() || !suits(*it)) return {};
    if (!found.empty() && found.front()->values.index() != it->values.index()) return {};
    found.push_back(&*it);
  }
  return found;
}

bool printable_word(std::string_view name) {
  return !name.empty() && std::ranges::all_of(name, [](char c) { return c > ' ' && c <= '~'; });
}

}  // namespace

AttributeGroups grouped(std::span<const Attribute> attributes) {
  constexpr std::array<std::string_view, 4> kColours = {"red", "green", "blue", "alpha"};
  constexpr std::array<std::string_view, 3> kNormals = {"nx", "ny", "nz"};
  AttributeGroups groups;
  groups.colours = of_one_type(attributes, kColours, can_be_colour);
  if (groups.colours.empty()) {
    groups.colours = of_one_type(attributes, std::span(kColours).first(3), can_be_colour);
  }
  groups.normals = of_one_type(attributes, kNormals, finite_floats);
  for (const Attribute& attribute : attributes) {
    const auto is_in = [&](const AttributeRefs& group) {
      return std::ranges::find(group, &attribute) != group.end();
    };
    if (!is_in(groups.colours) && !is_in(groups.normals)) groups.others.push_back(&attribute);
  }
  return groups;
}

void drop_alpha(AttributeGroups& groups) {
  if (groups.colours.size() < 4) return;
  groups.others.push_back(groups.colours.back());
  groups.colours.pop_back();
}

AttributeRefs nameable(const AttributeRefs& attributes, std::span<const std::string_view> taken,
                       std::vector<std::string>& dropped) {
  AttributeRefs kept;
  for (const Attribute* attribute : attributes) {
    const std::string& name = attribute->name;
    const bool known = std::ranges::find(taken, name) != taken.end() ||
                       std::ranges::find(kept, name, &Attribute::name) != kept.end();
    if (printable_word(name) && !known) {
      kept.push_back(attribute);
    } else {
      dropped.push_back(name);
    }
  }
  return kept;
}

AttributeRefs refs_to(std::span<const Attribute> attributes) {
  AttributeRefs refs;
  for (const Attribute& attribute : attributes) refs.push_back(&attribute);
  return refs;
}

std::vector<std::string> names_of(const AttributeRefs& attributes) {
  std::vector<std::string> names;
  for (const Attribute* attribute : attributes) names.push_back(attribute->name);
  return names;
}

}  // namespace tetsculpt
