#include "io/gltf_parts.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>

#include "io/attribute_groups.h"

namespace tetsculpt {
namespace {

constexpr std::endian kOrder = std::endian::little;

template <typename Value>
constexpr GltfType type_of() {
  if constexpr (std::is_same_v<Value, std::int8_t>) return GltfType::kInt8;
  if constexpr (std::is_same_v<Value, std::uint8_t>) return GltfType::kUint8;
  if constexpr (std::is_same_v<Value, std::int16_t>) return GltfType::kInt16;
  if constexpr (std::is_same_v<Value, std::uint16_t>) return GltfType::kUint16;
  return GltfType::kFloat32;  // nothing wider is allowed for attributes
}

constexpr std::size_t multiple_of_four(std::size_t size) { return (size + 3) / 4 * 4; }

template <typename Test>
bool all_values(const Attribute& attribute, const Test& test) {
  return std::visit(
      [&](const auto& values) {
        return std::ranges::all_of(values, [&](auto v) { return test(static_cast<double>(v)); });
      },
      attribute.values);
}

bool fit_floats(const Attribute* attribute) {
  return all_values(*attribute, [](double value) {
    return std::abs(value) <= std::numeric_limits<float>::max();
  });
}

bool is_float(double value) { return static_cast<double>(static_cast<float>(value)) == value; }

// The attributes as the components of one accessor; they are of one type.
GltfPart attribute_part(std::string semantic, const AttributeRefs& attributes, std::size_t count,
                        WriteReport& report) {
  for (const Attribute* attribute : attributes) {
    if (!all_values(*attribute, is_float)) report.rounded.push_back(attribute->name);
  }
  GltfPart part{.semantic = std::move(semantic), .count = count, .components = attributes.size()};
  std::visit(
      [&]<typename Value>(const std::vector<Value>&) {
        part.type = type_of<Value>();
        using Stored = std::conditional_t<sizeof(Value) <= 2, Value, float>;
        part.stride = multiple_of_four(sizeof(Stored) * attributes.size());
        part.store = [attributes, stride = part.stride](RowRange rows, char* to) {
          for (const Attribute* attribute : attributes) {
            const auto& values = std::get<std::vector<Value>>(attribute->values);
            store_column(to, stride, rows, kOrder,
                         [&](std::size_t i) { return static_cast<Stored>(values[i]); });
            to += sizeof(Stored);
          }
        };
      },
      attributes.front()->values);
  return part;
}

std::string list_of(const std::array<float, 3>& values) {
  std::string text = "[";
  for (const float value : values) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    text.append(text.size() > 1 ? "," : "").append(digits.data(), end);
  }
  return text + "]";
}

GltfPart position_part(const TriangleMesh& mesh, const Point3& origin) {
  const auto floats = [&mesh, origin](std::size_t i) {
    const Point3& p = mesh.points[i];
    return std::array<float, 3>{static_cast<float>(p.x - origin.x),
                                static_cast<float>(p.y - origin.y),
                                static_cast<float>(p.z - origin.z)};
  };
  std::array<float, 3> low = floats(0);
  std::array<float, 3> high = low;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const std::array<float, 3> p = floats(i);
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  return {
      .semantic = "POSITION",
      .count = mesh.points.size(),
      .stride = 12,
      .components = 3,
      .bounds =
          std::string("\"min\":").append(list_of(low)).append(",\"max\":").append(list_of(high)),
      .store = [floats](RowRange rows, char* to) {
        for (std::size_t i = rows.first; i < rows.first + rows.count; ++i) {
          for (const float value : floats(i)) to = store_number(to, value, kOrder);
        }
      }};
}

GltfPart index_part(const TriangleMesh& mesh) {
  return {.semantic = "",
          .count = 3 * mesh.triangles.size(),
          .stride = 4,
          .type = GltfType::kUint32,
          .store = [&mesh](RowRange rows, char* to) {
            std::size_t triangle = rows.first / 3;
            std::size_t corner = rows.first % 3;
            for (std::size_t left = rows.count; left > 0; --left) {
              to = store_number(to, mesh.triangles[triangle][corner], kOrder);
              if (++corner < 3) continue;
              corner = 0;
              ++triangle;
            }
          }};
}

// Validators allow lengths about so far from one.
bool are_units(const AttributeRefs& normals, std::size_t count) {
  if (normals.empty()) return false;
  constexpr double kTolerance = 0.005;
  const auto value = [&](std::size_t k, std::size_t i) {
    return std::visit([&](const auto& values) { return static_cast<double>(values[i]); },
                      normals[k]->values);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const double length = std::hypot(value(0, i), value(1, i), value(2, i));
    if (!(std::abs(length - 1) <= kTolerance)) return false;
  }
  return true;
}

}  // namespace

std::vector<GltfPart> gltf_parts(const TriangleMesh& mesh, const Point3& origin,
                                 std::span<const Attribute> attributes, WriteReport& report) {
  const std::size_t count = mesh.points.size();
  if (count == 0) return {};
  AttributeGroups groups = grouped(attributes);
  std::vector<GltfPart> parts = {position_part(mesh, origin)};
  const auto add_group = [&](const char* semantic, const AttributeRefs& group, bool fits) {
    if (group.empty()) return;
    if (fits) {
      parts.push_back(attribute_part(semantic, group, count, report));
    } else {
      groups.others.insert(groups.others.end(), group.begin(), group.end());
    }
  };
  add_group("NORMAL", groups.normals, are_units(groups.normals, count));
  add_group("COLOR_0", groups.colours, std::ranges::all_of(groups.colours, fit_floats));
  for (const Attribute* attribute : nameable(groups.others, {}, report.dropped)) {
    if (fit_floats(attribute)) {
      parts.push_back(
          attribute_part(std::string("_").append(attribute->name), {attribute}, count, report));
    } else {
      report.dropped.push_back(attribute->name);
    }
  }
  for (GltfPart& part : parts)
    part.normalized = part.semantic == "COLOR_0" && part.type != GltfType::kFloat32;
  if (!mesh.triangles.empty()) parts.push_back(index_part(mesh));
  return parts;
}

}  // namespace tetsculpt
