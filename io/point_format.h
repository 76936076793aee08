#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace tetsculpt {

/// Formats of files that hold points. kPts is text with columns of its own.
enum class PointFormat { kText, kPts, kPly, kObj, kOff, kStl, kPcd, kLas, kVtk };

/// The format with this name: an extension without its dot, in lower case ("xyz", "ply").
std::optional<PointFormat> point_format_named(std::string_view name);

/// The format that the extension of `path` names, in either case.
std::optional<PointFormat> point_format_of(const std::filesystem::path& path);

/// Its name; of text, the first of several.
std::string_view point_format_name(PointFormat format);

/// All names, in a fixed order, with dots: ".xyz .txt ...".
std::string point_format_extensions();

}  // namespace tetsculpt
