#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/point_format.h"

/// What a file is by its first bytes.
namespace tetsculpt {

/// The format whose mark the content bears, so that nothing else can be meant.
std::optional<PointFormat> marked_format(std::string_view content);

/// The format that content without a mark looks like: lines `v x y z`, or a line of three numbers
/// among its first.
std::optional<PointFormat> apparent_format(std::string_view content);

/// Why content that is known, but no points in a form that is read, cannot be: compressed files,
/// text in UTF-16, pictures and others, with what to do about it.
std::optional<std::string> known_as_unreadable(std::string_view content);

}  // namespace tetsculpt
