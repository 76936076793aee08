#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace tetsculpt {

/// The values of an attribute in the type its file gives them, one per point.
using AttributeValues =
    std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                 std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<std::uint32_t>,
                 std::vector<float>, std::vector<double>>;

/// One scalar that points have besides their position. Names are those of PLY files whatever the
/// format: red, green, blue, alpha, intensity, nx, ny, nz, and any other.
struct Attribute {
  std::string name;
  AttributeValues values;

  friend bool operator==(const Attribute&, const Attribute&) = default;
};

/// The attribute whose i-th value is value `from[i]` of `attribute`.
/// Precondition: each index is one of a value.
Attribute gathered(const Attribute& attribute, std::span<const std::uint32_t> from);

}  // namespace tetsculpt
