#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "io/atomic_file.h"
#include "kernel/point.h"

/// Rows of numbers as the text formats have them.
namespace tetsculpt {

/// Writes `prefix`, x, y, z and a line end, with blanks between the numbers. Each number is the
/// shortest text that reads back as the same double; -0.0 keeps its sign.
void write_point_row(AtomicFile& out, std::string_view prefix, const Point3& point);

/// Writes `prefix`, the three indices counted from `first`, and `suffix`.
void write_index_row(AtomicFile& out, std::string_view prefix,
                     const std::array<std::uint32_t, 3>& triangle, std::uint64_t first,
                     std::string_view suffix);

}  // namespace tetsculpt
