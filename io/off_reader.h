#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "io/text_scanner.h"
#include "kernel/point.h"

namespace tetsculpt {

struct OffCounts {
  std::uint64_t vertices = 0;
  std::optional<std::uint64_t> faces;  ///< files of points may leave it out
};

/// Reads the header of an OFF text up to and including its counts, from a scanner that stands
/// before it. Throws IoError as parse_off_points.
OffCounts parse_off_counts(TextScanner& in);

/// The vertices of an OFF text (Geomview's object file format), one per line; the faces are not
/// looked at. Before the keyword OFF may stand ST, C and N: their data follow x, y and z.
/// The counts may stand behind the keyword, even without a blank.
/// Throws IoError with `path` and the line on any other header and if a vertex is missing.
std::vector<Point3> parse_off_points(std::string_view text, const std::filesystem::path& path);

}  // namespace tetsculpt
