#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/attribute.h"

/// Attributes as the formats of meshes sort them.
namespace tetsculpt {

using AttributeRefs = std::vector<const Attribute*>;

struct AttributeGroups {
  /// red, green, blue, and alpha if there is one, all of one type: uint8 and uint16 mean shares of
  /// their largest value, float and double (only finite) are the shares. Or empty.
  AttributeRefs colours = {};
  /// nx, ny, nz, all float or all double, finite. Or empty.
  AttributeRefs normals = {};
  AttributeRefs others = {};
};

/// Each attribute in one group; of equal names only the first can be a colour or a normal.
/// Holds pointers into `attributes`.
AttributeGroups grouped(std::span<const Attribute> attributes);

/// Moves alpha from the colours to the others.
void drop_alpha(AttributeGroups& groups);

/// The attributes that can be named in a file: not empty, printable ASCII without blanks, neither
/// the same as an earlier one nor one of `taken`. The names of the others are added to `dropped`.
AttributeRefs nameable(const AttributeRefs& attributes, std::span<const std::string_view> taken,
                       std::vector<std::string>& dropped);

AttributeRefs refs_to(std::span<const Attribute> attributes);

std::vector<std::string> names_of(const AttributeRefs& attributes);

}  // namespace tetsculpt
