// The legacy formats of "VTK File Formats" (the Visualization Toolkit), versions 1.0 to 5.1.
#include "io/vtk_reader.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/column_names.h"
#include "io/vtk_scanner.h"

namespace tetsculpt {
namespace {

// Data that a line announces by a name and a type.
constexpr std::pair<std::string_view, std::uint64_t> kNamedArrays[] = {
    {"VECTORS", 3},    {"NORMALS", 3},      {"TENSORS", 9},   {"TENSORS6", 6},
    {"GLOBAL_IDS", 1}, {"PEDIGREE_IDS", 1}, {"EDGE_FLAGS", 1}};

bool is_cells(std::string_view keyword) {
  constexpr std::array kCells = {"VERTICES", "LINES", "POLYGONS", "TRIANGLE_STRIPS", "CELLS"};
  return std::ranges::find(kCells, keyword) != kCells.end();
}

class VtkReader {
 public:
  VtkReader(std::string_view content, const std::filesystem::path& path) : in_(content, path) {}

  PointFile parse() && {
    while (in_.next_line()) section(in_.line().token());
    if (!has_points_) in_.line().fail("the file has no POINTS");
    return std::move(file_);
  }

 private:
  void section(std::string_view keyword) {
    TextScanner& line = in_.line();
    if (keyword == "DATASET") {
      check_kind(line.token());
    } else if (keyword == "POINTS") {
      points();
    } else if (is_cells(keyword)) {
      in_.skip_cells();
    } else if (keyword == "CELL_TYPES") {
      in_.skip({NumberType::kInt32, line.count()});
    } else if (keyword == "POINT_DATA" || keyword == "CELL_DATA") {
      begin_data(keyword == "POINT_DATA");
    } else if (keyword == "METADATA") {
      in_.skip_block();
    } else if (keyword != "DIMENSIONS") {
      array(keyword);
    }
  }

  void check_kind(std::string_view kind) {
    constexpr std::array kKinds = {"POLYDATA", "UNSTRUCTURED_GRID", "STRUCTURED_GRID"};
    if (std::ranges::find(kKinds, kind) != kKinds.end()) return;
    in_.line().fail("DATASET '" + std::string(kind) +
                    "' has no list of points; POLYDATA, UNSTRUCTURED_GRID and STRUCTURED_GRID "
                    "are read");
  }

  void points() {
    TextScanner& line = in_.line();
    if (std::exchange(has_points_, true)) line.fail("a second section POINTS");
    const std::uint64_t count = line.count();
    const VtkArray array{in_.type(), count, 3};
    if (!array.type) line.fail("points of type bit");
    file_.points = in_.points(array);
    if (array.type == NumberType::kFloat32) file_.precision = Precision::kSingle;
  }

  void begin_data(bool of_points) {
    of_points_ = of_points;
    tuples_ = in_.line().count();
    if (!of_points || tuples_ == file_.points.size()) return;
    in_.line().fail("data of " + std::to_string(tuples_) + " points; the file has " +
                    std::to_string(file_.points.size()));
  }

  void array(std::string_view keyword) {
    TextScanner& line = in_.line();
    if (keyword == "FIELD") {
      fields();
      return;
    }
    const std::string name(line.token());
    if (keyword == "SCALARS") {
      const std::optional<NumberType> type = in_.type();
      const std::uint64_t components = line.at_line_end() ? 1 : line.count();
      if (in_.next_begins_with("LOOKUP_TABLE")) skip_next_line();
      keep(name, {type, tuples_, components});
    } else if (keyword == "COLOR_SCALARS") {
      colours(name, {byte_or_share(), tuples_, line.count()});
    } else if (keyword == "LOOKUP_TABLE") {
      in_.skip({byte_or_share(), line.count(), 4});
    } else if (keyword == "TEXTURE_COORDINATES") {
      const std::uint64_t components = line.count();
      keep(name, {in_.type(), tuples_, components});
    } else {
      named_array(keyword, name);
    }
  }

  void skip_next_line() {
    in_.next_line();
    while (!in_.line().at_line_end()) in_.line().token();
  }

  NumberType byte_or_share() const {
    return in_.binary() ? NumberType::kUint8 : NumberType::kFloat64;
  }

  void named_array(std::string_view keyword, const std::string& name) {
    const auto* const found = std::ranges::find(kNamedArrays, keyword,
                                                &std::pair<std::string_view, std::uint64_t>::first);
    if (found == std::end(kNamedArrays)) {
      in_.line().fail("not a section of a VTK file");
    }
    const VtkArray array{in_.type(), tuples_, found->second};
    if (keyword == "NORMALS") {
      keep(std::array<std::string, 3>{"nx", "ny", "nz"}, array);
    } else {
      keep(name, array);
    }
  }

  void fields() {
    in_.fields([this](const std::string& name, const VtkArray& array) {
      if (of_points_ && array.tuples != tuples_) {
        in_.line().fail("an array of " + std::to_string(array.tuples) + " values for " +
                        std::to_string(tuples_) + " points");
      }
      keep(name, array);
    });
  }

  void colours(const std::string& name, const VtkArray& array) {
    std::vector<std::string> names = {"red", "green", "blue", "alpha"};
    if (array.components == 3) names.pop_back();
    if (array.components == names.size()) {
      keep(names, array);
    } else {
      keep(name, array);
    }
  }

  void keep(const std::string& name, const VtkArray& array) {
    if (array.components == 1) {
      keep(canonical_names({name}), array);
      return;
    }
    in_.checked_numbers(array);  // before so many names are made
    std::vector<std::string> names;
    for (std::size_t i = 0; i < array.components; ++i) names.push_back(part_name(name, i));
    keep(names, array);
  }

  void keep(std::span<const std::string> names, const VtkArray& array) {
    if (!of_points_ || !array.type) {
      in_.skip(array);
      return;
    }
    std::vector<AttributeValues> columns = in_.columns(array);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      file_.attributes.push_back({names[i], std::move(columns[i])});
    }
  }

  VtkScanner in_;
  PointFile file_;
  bool has_points_ = false;
  bool of_points_ = false;    // the section is of POINT_DATA
  std::uint64_t tuples_ = 0;  // that an array of the section has
};

}  // namespace

PointFile parse_vtk_points(std::string_view content, const std::filesystem::path& path) {
  return VtkReader(content, path).parse();
}

}  // namespace tetsculpt
