#include "io/ply_reader.h"

#include <algorithm>
#include <cstddef>

#include "io/ply_ascii_body.h"
#include "io/ply_binary_body.h"
#include "io/ply_header.h"
#include "io/text_scanner.h"

namespace tetsculpt {
namespace {

Precision precision_of(const PlyElement& vertices) {
  const bool single = std::ranges::all_of(vertices.properties, [](const PlyProperty& property) {
    return property.role == PlyRole::kOther || property.type == PlyType::kFloat32;
  });
  return single ? Precision::kSingle : Precision::kDouble;
}

}  // namespace

PointFile parse_ply_points(std::string_view content, const std::filesystem::path& path) {
  constexpr TextDialect kDialect = {.separators = " \t", .comments = {}};
  TextScanner in(content, path, kDialect);
  const PlyHeader header = parse_ply_header(in);
  const Precision precision = precision_of(header.vertices);
  if (header.format == PlyFormat::kAscii) return {parse_ply_ascii_body(header, in), precision, {}};
  const std::size_t begin = ply_body_begin(content, in.next_offset());
  return {parse_ply_binary_body(header, content, begin, path), precision, {}};
}

}  // namespace tetsculpt
