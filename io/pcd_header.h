#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/number_type.h"
#include "io/text_scanner.h"

namespace tetsculpt {

enum class PcdData { kAscii, kBinary, kCompressed };

struct PcdField {
  std::string name;
  NumberType type = NumberType::kFloat32;
  std::size_t count = 1;  ///< numbers of a point
};

struct PcdHeader {
  std::vector<PcdField> fields;
  std::uint64_t points = 0;
  PcdData data = PcdData::kAscii;
};

/// Reads a header with all its lines up to DATA, in any order.
/// Throws IoError with the line if it is not one or contradicts itself.
PcdHeader parse_pcd_header(TextScanner& in);

/// The bytes of a point.
std::size_t record_size(const PcdHeader& header);

}  // namespace tetsculpt
