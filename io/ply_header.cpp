// The header of the PLY format as described by Greg Turk, "The PLY Polygon File Format" (1994),
// with the type names int8 ... float64 that later programs added.
#include "io/ply_header.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace tetsculpt {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array<TypeName, 16> kTypeNames = {{
    {"char", PlyType::kInt8},
    {"int8", PlyType::kInt8},
    {"uchar", PlyType::kUint8},
    {"uint8", PlyType::kUint8},
    {"short", PlyType::kInt16},
    {"int16", PlyType::kInt16},
    {"ushort", PlyType::kUint16},
    {"uint16", PlyType::kUint16},
    {"int", PlyType::kInt32},
    {"int32", PlyType::kInt32},
    {"uint", PlyType::kUint32},
    {"uint32", PlyType::kUint32},
    {"float", PlyType::kFloat32},
    {"float32", PlyType::kFloat32},
    {"double", PlyType::kFloat64},
    {"float64", PlyType::kFloat64},
}};

PlyType parse_type(TextScanner& in) {
  const std::string_view name = in.token();
  const auto* found = std::ranges::find(kTypeNames, name, &TypeName::name);
  if (found == kTypeNames.end()) in.fail("unknown type '" + std::string(name) + "'");
  return found->type;
}

PlyFormat parse_format(TextScanner& in) {
  const std::string_view name = in.token();
  if (in.token() != "1.0") in.fail("the format version is not 1.0");
  if (name == "ascii") return PlyFormat::kAscii;
  if (name == "binary_little_endian") return PlyFormat::kLittleEndian;
  if (name == "binary_big_endian") return PlyFormat::kBigEndian;
  in.fail("unknown format '" + std::string(name) + "'");
}

PlyRole role_of(std::string_view name) {
  if (name == "x") return PlyRole::kX;
  if (name == "y") return PlyRole::kY;
  if (name == "z") return PlyRole::kZ;
  return PlyRole::kOther;
}

PlyProperty parse_property(TextScanner& in) {
  PlyProperty property;
  if (TextScanner look = in; look.token() == "list") {
    in.token();
    property.list_length = parse_type(in);
    if (*property.list_length >= PlyType::kFloat32) in.fail("a list length must be an integer");
  }
  property.type = parse_type(in);
  property.name = in.token();
  if (property.name.empty()) in.fail("the property has no name");
  property.role = role_of(property.name);
  return property;
}

PlyElement parse_element(TextScanner& in) {
  PlyElement element;
  element.name = in.token();
  if (element.name.empty()) in.fail("the element has no name");
  element.count = in.count();
  return element;
}

void check_coordinate(const PlyElement& vertices, std::string_view name, const TextScanner& in) {
  const auto found = std::ranges::find(vertices.properties, role_of(name), &PlyProperty::role);
  if (found == vertices.properties.end()) {
    in.fail("the element vertex has no property " + std::string(name));
  }
  if (found->list_length) in.fail("the property " + std::string(name) + " is a list");
}

// Collects the lines of a header and checks how they go together.
class HeaderBuilder {
 public:
  explicit HeaderBuilder(TextScanner& in) : in_(in) {}

  // False if the line was the last one.
  bool take_line() {
    const std::string_view keyword = in_.token();
    if (keyword == "end_header") return false;
    if (keyword == "format") {
      if (std::exchange(has_format_, true)) in_.fail("a second format line");
      header_.format = parse_format(in_);
    } else if (keyword == "element") {
      add_element(parse_element(in_));
    } else if (keyword == "property") {
      add_property(parse_property(in_));
    } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
      in_.fail("not a line of a PLY header");
    }
    return true;
  }

  PlyHeader finish() && {
    if (!has_format_) in_.fail("the header has no format line");
    if (!has_vertices_) in_.fail("the header has no element vertex");
    for (const char* name : {"x", "y", "z"}) check_coordinate(header_.vertices, name, in_);
    return std::move(header_);
  }

 private:
  void add_element(PlyElement element) {
    in_vertices_ = element.name == "vertex";
    if (in_vertices_) {
      if (std::exchange(has_vertices_, true)) in_.fail("a second element vertex");
      header_.vertices = std::move(element);
    } else {
      others().push_back(std::move(element));
    }
    has_element_ = true;
  }

  void add_property(const PlyProperty& property) {
    if (!has_element_) in_.fail("a property before the first element");
    if (in_vertices_) {
      if (property.role != PlyRole::kOther &&
          std::ranges::count(header_.vertices.properties, property.role, &PlyProperty::role) > 0) {
        in_.fail("a coordinate for the second time");
      }
      header_.vertices.properties.push_back(property);
    } else {
      others().back().properties.push_back(property);
    }
  }

  std::vector<PlyElement>& others() {
    return has_vertices_ ? header_.after_vertices : header_.before_vertices;
  }

  TextScanner& in_;
  PlyHeader header_;
  bool has_format_ = false;
  bool has_element_ = false;
  bool has_vertices_ = false;
  bool in_vertices_ = false;  // the latest element is the vertex element
};

}  // namespace

PlyHeader parse_ply_header(TextScanner& in) {
  in.next_line();
  if (in.token() != "ply" || !in.at_line_end()) in.fail("not a PLY file");
  HeaderBuilder builder(in);
  do {
    if (!in.next_line()) in.fail("the file ends within the header");
  } while (builder.take_line());
  return std::move(builder).finish();
}

std::size_t ply_body_begin(std::string_view content, std::size_t after_header) {
  const bool lone_cr = content.starts_with("ply\r") && !content.starts_with("ply\r\n");
  return lone_cr && content[after_header - 1] == '\n' ? after_header - 1 : after_header;
}

std::size_t byte_size(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8:
      return 1;
    case PlyType::kInt16:
    case PlyType::kUint16:
      return 2;
    case PlyType::kInt32:
    case PlyType::kUint32:
    case PlyType::kFloat32:
      return 4;
    case PlyType::kFloat64:
      break;
  }
  return 8;
}

}  // namespace tetsculpt
