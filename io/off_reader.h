#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "io/point_file.h"
#include "io/text_scanner.h"

namespace tetsculpt {

struct OffCounts {
  std::uint64_t vertices = 0;
  std::optional<std::uint64_t> faces;  ///< files of points may leave it out
  /// What follows x, y and z, by the keyword.
  bool normals = false;   ///< N
  bool colours = false;   ///< C
  bool textures = false;  ///< ST
};

/// Reads the header of an OFF text up to and including its counts, from a scanner that stands
/// before it. Throws IoError as parse_off_points.
OffCounts parse_off_counts(TextScanner& in);

/// The vertices of an OFF text (Geomview's object file format), one per line; the faces are not
/// looked at. Before the keyword OFF may stand ST, C and N.
///   (1) Vertices with as many further numbers as the keyword says have attributes: nx ny nz, red
///       green blue or red green blue alpha, s t; other further numbers are scalar_4, ...; see
///       io/point_rows.h.
///   (2) The counts may stand behind the keyword, even without a blank.
/// Throws IoError with `path` and the line on any other header, in particular of a binary file,
/// and if a vertex is missing.
PointFile parse_off_points(std::string_view text, const std::filesystem::path& path);

}  // namespace tetsculpt
