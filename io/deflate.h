#pragma once

#include <string>
#include <string_view>

namespace tetsculpt {

/// `bytes` compressed, as the zlib stream that PNG asks for.  [RFC 1950, RFC 1951]
///   (1) The same bytes, the same stream, everywhere.
///   (2) Never longer than the input by more than 6 bytes in 32768, and 12.
std::string zlib_stream(std::string_view bytes);

}  // namespace tetsculpt
