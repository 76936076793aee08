#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tetsculpt {

/// `bytes` in the base64 alphabet, padded with '=' to a multiple of four, without line ends.
/// Texts of pieces whose sizes are multiples of three can be joined.  [RFC 4648, section 4]
std::string base64(std::string_view bytes);

/// The bytes of such a text; empty if it is none.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace tetsculpt
