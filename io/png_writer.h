#pragma once

#include <filesystem>
#include <string>

#include "io/image.h"

namespace tetsculpt {

/// `image` as a PNG file: 8 bits per channel, no alpha, not interlaced.
/// Precondition: width and height are from 1 to 2^31 - 1.  [W3C PNG, second edition]
std::string png(const Image& image);

/// Writes png(image). The file appears whole or not at all, see io/atomic_file.h.
/// Throws IoError on a failing disk.
void write_png(const Image& image, const std::filesystem::path& path);

}  // namespace tetsculpt
