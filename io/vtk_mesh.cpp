#include "io/vtk_mesh.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/polygon_fan.h"
#include "io/quoted.h"
#include "io/vtk_cursor.h"

namespace tetsculpt {
namespace {

class VtkParser {
 public:
  VtkParser(std::string_view content, const std::filesystem::path& path)
      : in_(content, path), fan_(file_.mesh.triangles) {}

  MeshFile parse() && {
    parse_header();
    while (!in_.at_end() && in_.peek() != "POINT_DATA" && in_.peek() != "CELL_DATA") {
      parse_section();
    }
    if (!has_points_) in_.fail("the file has no POINTS");
    if (!has_polygons_) in_.fail("the file has no POLYGONS");
    return std::move(file_);
  }

 private:
  // How the cells of a section stand there: each with its length before its corners, or the ends of
  // all, then the corners of all.
  struct Cells {
    std::uint64_t count = 0;
    std::uint64_t values = 0;
  };

  void parse_header() {
    if (!in_.line().starts_with("# vtk DataFile Version")) in_.fail("not a legacy VTK file");
    in_.line();  // the title
    const std::string_view form = in_.word();
    if (form != "ASCII" && form != "BINARY") in_.fail("expected ASCII or BINARY");
    in_.expect("DATASET");
    const std::string_view dataset = in_.word();
    if (dataset != "POLYDATA") in_.fail("a mesh has the dataset POLYDATA, not " + quoted(dataset));
    if (form == "BINARY") in_.set_binary();
  }

  void parse_section() {
    const std::string_view name = in_.word();
    if (name == "POINTS") {
      parse_points();
    } else if (name == "POLYGONS") {
      has_polygons_ = true;
      if (!has_points_) in_.fail("POLYGONS before POINTS");
      parse_polygons();
    } else if (name == "VERTICES" || name == "LINES") {
      skip_cells();
    } else if (name == "TRIANGLE_STRIPS") {
      in_.fail("triangle strips are not read");
    } else if (name == "METADATA") {
      skip_metadata();
    } else if (name == "FIELD") {
      skip_field();
    } else {
      in_.fail("not a section of POLYDATA: " + quoted(name));
    }
  }

  void parse_points() {
    if (std::exchange(has_points_, true)) in_.fail("POINTS for the second time");
    const std::uint64_t count = in_.count();
    const NumberType type = in_.type();
    if (count > UINT32_MAX) in_.fail("more points than 32-bit indices can tell apart");
    in_.begin_values(3 * count, type);
    if (type == NumberType::kFloat32) file_.precision = Precision::kSingle;
    file_.mesh.points.reserve(static_cast<std::size_t>(count));
    for (std::uint64_t i = 0; i < count; ++i) {
      const double x = in_.number(type);
      const double y = in_.number(type);
      const double z = in_.number(type);
      file_.mesh.points.push_back({x, y, z});
    }
  }

  void parse_polygons() {
    const Cells cells{in_.count(), in_.count()};
    if (in_.peek() == "OFFSETS") return parse_connectivity(cells);
    in_.begin_values(cells.values, NumberType::kInt32);
    std::uint64_t left = cells.values;
    for (std::uint64_t i = 0; i < cells.count; ++i) {
      if (left == 0) in_.fail("the polygons have more values than announced");
      const std::int64_t corners = in_.integer(NumberType::kInt32);
      --left;
      if (corners < 0 || static_cast<std::uint64_t>(corners) > left) {
        in_.fail("a polygon of " + std::to_string(corners) + " corners, " + std::to_string(left) +
                 " values left");
      }
      for (std::int64_t k = 0; k < corners; ++k) parse_corner(NumberType::kInt32);
      left -= static_cast<std::uint64_t>(corners);
      if (const auto fault = fan_.finish()) in_.fail(*fault);
    }
    if (left > 0) in_.fail("the polygons have fewer values than announced");
  }

  // `cells` counts offsets, one more than polygons, and corners.
  void parse_connectivity(const Cells& cells) {
    in_.word();
    NumberType type = integer_type();
    in_.begin_values(cells.count, type);
    std::vector<std::int64_t> offsets;
    offsets.reserve(static_cast<std::size_t>(cells.count));
    for (std::uint64_t i = 0; i < cells.count; ++i) {
      const std::int64_t offset = in_.integer(type);
      if (offset < (i == 0 ? 0 : offsets.back())) in_.fail("offsets that do not ascend");
      if (i == 0 && offset != 0) in_.fail("the first offset is not 0");
      offsets.push_back(offset);
    }
    const std::int64_t end = offsets.empty() ? 0 : offsets.back();
    if (static_cast<std::uint64_t>(end) != cells.values) {
      in_.fail("the last offset is not the number of corners");
    }
    in_.expect("CONNECTIVITY");
    type = integer_type();
    in_.begin_values(cells.values, type);
    for (std::size_t i = 1; i < offsets.size(); ++i) {
      for (std::int64_t k = offsets[i - 1]; k < offsets[i]; ++k) parse_corner(type);
      if (const auto fault = fan_.finish()) in_.fail(*fault);
    }
  }

  NumberType integer_type() {
    const NumberType type = in_.type();
    if (type >= NumberType::kFloat32) in_.fail("indices must be integers");
    return type;
  }

  void parse_corner(NumberType type) {
    const std::int64_t index = in_.integer(type);
    const std::size_t vertices = file_.mesh.points.size();
    if (index < 0 || static_cast<std::uint64_t>(index) >= vertices) {
      in_.fail(no_such_vertex(std::to_string(index), vertices));
    }
    fan_.add(static_cast<std::uint32_t>(index));
  }

  void skip_cells() {
    const Cells cells{in_.count(), in_.count()};
    if (in_.peek() != "OFFSETS") return in_.skip_values(cells.values, NumberType::kInt32);
    in_.word();
    in_.skip_values(cells.count, in_.type());
    in_.expect("CONNECTIVITY");
    in_.skip_values(cells.values, in_.type());
  }

  // Lines up to a blank one.
  void skip_metadata() {
    in_.line();
    while (!in_.at_end() && !in_.line().empty()) {
    }
  }

  // FIELD name n, then n times: name components tuples type values.
  void skip_field() {
    in_.word();
    for (std::uint64_t left = in_.count(); left > 0; --left) {
      if (in_.word().empty()) in_.fail("the file ends within a field");
      const std::uint64_t components = in_.count();
      const std::uint64_t tuples = in_.count();
      if (components > 0 && tuples > UINT64_MAX / components) in_.fail("a field without end");
      in_.skip_values(components * tuples, in_.type());
    }
  }

  VtkCursor in_;
  MeshFile file_;
  PolygonFan fan_;
  bool has_points_ = false;
  bool has_polygons_ = false;
};

}  // namespace

MeshFile parse_vtk_mesh(std::string_view content, const std::filesystem::path& path) {
  return VtkParser(content, path).parse();
}

}  // namespace tetsculpt
