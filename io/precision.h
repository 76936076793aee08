#pragma once

namespace tetsculpt {

/// How many bits a coordinate has in a file.
enum class Precision {
  kSingle,  ///< 32-bit IEEE 754
  kDouble,  ///< 64-bit IEEE 754
};

}  // namespace tetsculpt
