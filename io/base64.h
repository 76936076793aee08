#pragma once

#include <string>
#include <string_view>

namespace tetsculpt {

/// `bytes` in the base64 alphabet, padded with '=' to a multiple of four, without line ends.
/// Texts of pieces whose sizes are multiples of three can be joined.  [RFC 4648, section 4]
std::string base64(std::string_view bytes);

}  // namespace tetsculpt
