#pragma once

#include <filesystem>
#include <string_view>

#include "io/point_file.h"
#include "io/text_columns.h"

namespace tetsculpt {

/// The points of a text with one point per line: numbers between blanks, tabs, commas or
/// semicolons.
///   (1) Blank lines and lines that begin with # or // are skipped.
///   (2) Before the first point there may be one line of column titles (it does not begin with a
///       number) and one line with nothing but the number of points, which then has to be right.
///   (3) Titles, or a comment before the first point, that name x, y and z say where they are, and
///       what the other columns are; otherwise the first three columns are x, y and z. What cannot
///       be told from the text is `usual`; the other columns are scalar_4, scalar_5, ...; see
///       io/text_columns.h.
///   (4) A further column becomes an attribute if every row has a number in it, see
///       io/point_rows.h. Nothing between two commas is an empty cell.
/// Throws IoError with `path` and the line if another line does not begin with three numbers, and
/// if commas look like decimal ones.
PointFile parse_text_points(std::string_view text, const std::filesystem::path& path,
                            TextColumns usual = TextColumns::kUnknown);

}  // namespace tetsculpt
