#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/text_scanner.h"

namespace tetsculpt {

enum class PlyFormat { kAscii, kLittleEndian, kBigEndian };
enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };
enum class PlyRole : std::uint8_t { kX, kY, kZ, kOther };

struct PlyProperty {
  std::string name;
  PlyRole role = PlyRole::kOther;
  PlyType type = PlyType::kFloat32;    ///< of the scalar or of the items of the list
  std::optional<PlyType> list_length;  ///< type of the length, an integer; none for a scalar
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

/// What has to be known to find the vertices and what comes after them.
struct PlyHeader {
  PlyFormat format = PlyFormat::kAscii;
  std::vector<PlyElement> before_vertices;
  PlyElement vertices;  ///< has each of kX, kY, kZ once, as scalar
  std::vector<PlyElement> after_vertices;
};

/// Reads a header with all its lines up to `end_header` from a scanner without comments.
/// Throws IoError with the line if it is not one, or there is no vertex element with x, y and z.
PlyHeader parse_ply_header(TextScanner& in);

/// Where the body of a binary file begins, given where the line after the header does: if the
/// lines of the header end with CR alone, an LF behind the last is already the first value.
std::size_t ply_body_begin(std::string_view content, std::size_t after_header);

std::size_t byte_size(PlyType type);

}  // namespace tetsculpt
