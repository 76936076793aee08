#include "io/off_reader.h"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "io/column_names.h"
#include "io/point_rows.h"

namespace tetsculpt {
namespace {

std::vector<std::string> names_of_row(const TextScanner& in, const OffCounts& announced) {
  constexpr std::size_t kMost = 100;
  const std::size_t count = count_cells(in, kMost);
  std::vector<std::string> names = {"x", "y", "z"};
  const auto add = [&names](std::initializer_list<const char*> more) {
    names.insert(names.end(), more.begin(), more.end());
  };
  if (announced.normals) add({"nx", "ny", "nz"});
  if (announced.colours) add({"red", "green", "blue"});
  const std::size_t after_alpha = announced.textures ? 2 : 0;
  if (announced.colours && count == names.size() + 1 + after_alpha) add({"alpha"});
  if (announced.textures) add({"s", "t"});
  if (names.size() == count) return names;
  names.resize(3);
  if (names.size() < count) names.resize(count);
  return canonical_names(std::move(names));
}

}  // namespace

OffCounts parse_off_counts(TextScanner& in) {
  in.next_content_line();
  OffCounts counts;
  counts.textures = in.accept("ST");
  counts.colours = in.accept("C");
  counts.normals = in.accept("N");
  if (!in.accept("OFF")) in.fail("not an OFF file: it does not begin with OFF");
  if (TextScanner look = in; look.token() == "BINARY") in.fail("binary OFF files are not read");
  if (in.at_line_end() && !in.next_content_line()) in.fail("the file ends before its counts");
  counts.vertices = in.count();
  if (!in.at_line_end()) counts.faces = in.count();
  return counts;
}

PointFile parse_off_points(std::string_view text, const std::filesystem::path& path) {
  constexpr TextDialect kDialect;
  TextScanner in(text, path, kDialect);
  const OffCounts counts = parse_off_counts(in);
  if (counts.vertices == 0) return {};
  std::optional<PointRows> rows;
  for (std::uint64_t i = 0; i < counts.vertices; ++i) {
    if (!in.next_content_line()) {
      in.fail("the file ends after " + std::to_string(i) + " of " +
              std::to_string(counts.vertices) + " vertices");
    }
    if (!rows) {
      rows.emplace(names_of_row(in, counts));
      const std::size_t row_size = in.rest_of_line().size() + 1;
      rows->reserve(std::min<std::uint64_t>(counts.vertices, in.bytes_left() / row_size + 1));
    }
    rows->take(in);
  }
  return std::move(*rows).finish();
}

}  // namespace tetsculpt
