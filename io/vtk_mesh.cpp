#include "io/vtk_mesh.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/number_type.h"
#include "io/polygon_fan.h"
#include "io/quoted.h"
#include "io/vtk_scanner.h"

namespace tetsculpt {
namespace {

class VtkMeshParser {
 public:
  VtkMeshParser(std::string_view content, const std::filesystem::path& path)
      : in_(content, path), fan_(file_.mesh.triangles) {}

  MeshFile parse() && {
    while (in_.next_line() && parse_section(in_.line().token())) {
    }
    if (!has_points_) fail("the file has no POINTS");
    if (!has_polygons_) fail("the file has no POLYGONS");
    return std::move(file_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) { in_.line().fail(reason); }

  // False if only data follow.
  bool parse_section(std::string_view name) {
    if (name == "DATASET") {
      const std::string_view kind = in_.line().token();
      if (kind != "POLYDATA") fail("a mesh has the dataset POLYDATA, not " + quoted(kind));
    } else if (name == "POINTS") {
      parse_points();
    } else if (name == "POLYGONS") {
      has_polygons_ = true;
      if (!has_points_) fail("POLYGONS before POINTS");
      parse_polygons();
    } else if (name == "VERTICES" || name == "LINES") {
      in_.skip_cells();
    } else if (name == "TRIANGLE_STRIPS") {
      fail("triangle strips are not read");
    } else if (name == "METADATA") {
      in_.skip_block();
    } else if (name == "FIELD") {
      in_.fields([this](const std::string&, const VtkArray& array) { in_.skip(array); });
    } else if (name != "POINT_DATA" && name != "CELL_DATA") {
      fail("not a section of POLYDATA: " + quoted(name));
    } else {
      return false;
    }
    return true;
  }

  void parse_points() {
    if (std::exchange(has_points_, true)) fail("POINTS for the second time");
    const std::uint64_t count = in_.line().count();
    const VtkArray array{in_.type(), count, 3};
    if (!array.type) fail("points of type bit");
    if (count > UINT32_MAX) fail("more points than 32-bit indices can tell apart");
    if (array.type == NumberType::kFloat32) file_.precision = Precision::kSingle;
    file_.mesh.points = in_.points(array);
  }

  void parse_polygons() {
    const VtkCells cells = in_.cells();
    if (cells.has_offsets) return parse_connectivity(cells);
    std::uint64_t polygons = 0;
    std::uint64_t left = cells.second;  // values
    std::uint64_t corners = 0;          // that the polygon still lacks
    in_.each_integer({NumberType::kInt32, cells.second}, [&](std::int64_t value) {
      --left;
      if (corners > 0) {
        add_corner(value);
        if (--corners == 0) finish_polygon();
        return;
      }
      if (polygons++ == cells.first) fail("the polygons have fewer values than announced");
      if (value < 0 || static_cast<std::uint64_t>(value) > left) {
        fail("a polygon of " + std::to_string(value) + " corners, " + std::to_string(left) +
             " values left");
      }
      corners = static_cast<std::uint64_t>(value);
      if (corners == 0) finish_polygon();
    });
    if (polygons < cells.first) fail("the polygons have more values than announced");
  }

  void parse_connectivity(const VtkCells& cells) {
    std::vector<std::int64_t> offsets;
    in_.each_integer({in_.type(), cells.first}, [&](std::int64_t offset) {
      if (offset < (offsets.empty() ? 0 : offsets.back())) fail("offsets that do not ascend");
      if (offsets.empty() && offset != 0) fail("the first offset is not 0");
      offsets.push_back(offset);
    });
    const std::int64_t end = offsets.empty() ? 0 : offsets.back();
    if (static_cast<std::uint64_t>(end) != cells.second) {
      fail("the last offset is not the number of corners");
    }
    const std::optional<NumberType> type = in_.connectivity();
    std::int64_t corner = 0;
    std::size_t next = 1;  // the offset at which the polygon ends
    const auto finish_polygons = [&] {
      for (; next < offsets.size() && offsets[next] == corner; ++next) finish_polygon();
    };
    finish_polygons();
    in_.each_integer({type, cells.second}, [&](std::int64_t index) {
      add_corner(index);
      ++corner;
      finish_polygons();
    });
  }

  void add_corner(std::int64_t index) {
    const std::size_t vertices = file_.mesh.points.size();
    if (index < 0 || static_cast<std::uint64_t>(index) >= vertices) {
      fail(no_such_vertex(std::to_string(index), vertices));
    }
    fan_.add(static_cast<std::uint32_t>(index));
  }

  void finish_polygon() {
    if (const auto fault = fan_.finish()) fail(*fault);
  }

  VtkScanner in_;
  MeshFile file_;
  PolygonFan fan_;
  bool has_points_ = false;
  bool has_polygons_ = false;
};

}  // namespace

MeshFile parse_vtk_mesh(std::string_view content, const std::filesystem::path& path) {
  return VtkMeshParser(content, path).parse();
}

}  // namespace tetsculpt
