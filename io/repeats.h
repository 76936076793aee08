#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace tetsculpt {

/// One step of a text told as new bytes and repeats of earlier ones.
struct RepeatStep {
  std::uint16_t length = 0;    ///< 3 to 258 bytes repeated; 0: one new byte
  std::uint16_t distance = 0;  ///< how far back they begin, 1 to 32768; they may overlap this place
  std::uint8_t byte = 0;       ///< the new byte
};

/// `bytes` as steps, with the long repeats that short hash chains find. Cost: near linear.
/// [Ziv, Lempel 1977; RFC 1951, sec. 4]
std::vector<RepeatStep> find_repeats(std::string_view bytes);

}  // namespace tetsculpt
