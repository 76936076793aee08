#include "io/obj_reader.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/column_names.h"
#include "io/point_rows.h"
#include "io/text_scanner.h"

namespace tetsculpt {
namespace {

std::vector<std::string> names_of_row(const TextScanner& in) {
  constexpr std::size_t kMost = 100;
  const std::size_t count = count_cells(in, kMost);
  if (count == 4) return {"x", "y", "z", ""};
  if (count == 6) return {"x", "y", "z", "red", "green", "blue"};
  if (count == 7) return {"x", "y", "z", "", "red", "green", "blue"};
  std::vector<std::string> names = {"x", "y", "z"};
  if (names.size() < count) names.resize(count);
  return canonical_names(std::move(names));
}

}  // namespace

PointFile parse_obj_points(std::string_view text, const std::filesystem::path& path) {
  constexpr TextDialect kDialect;
  TextScanner in(text, path, kDialect);
  std::optional<PointRows> rows;
  while (in.next_line()) {
    if (in.token() != "v") continue;
    if (!rows) rows.emplace(names_of_row(in));
    rows->take(in);
  }
  return rows ? std::move(*rows).finish() : PointFile();
}

}  // namespace tetsculpt
