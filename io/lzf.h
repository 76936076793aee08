#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace tetsculpt {

/// The `size` bytes that were compressed to `bytes` in the format of LibLZF; nothing if they are
/// not as many or `bytes` is broken. Takes no memory for a size that so many bytes cannot hold.
std::optional<std::string> lzf_decompressed(std::string_view bytes, std::size_t size);

}  // namespace tetsculpt
