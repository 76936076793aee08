#pragma once

#include <string>
#include <vector>

namespace tetsculpt {

/// What a file does not hold as it was. Empty lists: it holds everything, bit for bit.
struct WriteReport {
  /// The coordinates (x, y, z) and attributes of which a value was rounded to a 32-bit float.
  std::vector<std::string> rounded = {};
  /// The attributes that are not in the file: its format has no place for them.
  std::vector<std::string> dropped = {};

  friend bool operator==(const WriteReport&, const WriteReport&) = default;
};

}  // namespace tetsculpt
