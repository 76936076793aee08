#include "io/ply_mesh.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/ply_binary_cursor.h"
#include "io/ply_header.h"
#include "io/ply_reader.h"
#include "io/polygon_fan.h"
#include "io/text_scanner.h"

namespace tetsculpt {
namespace {

bool is_corner_list(const PlyProperty& property) {
  return property.list_length &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

bool is_face(const PlyElement& element) {
  return element.name == "face" && std::ranges::any_of(element.properties, is_corner_list);
}

std::string number_text(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

// The elements in the order of the file.
std::vector<PlyElement> all_elements(const PlyHeader& header) {
  std::vector<PlyElement> elements = header.before_vertices;
  elements.push_back(header.vertices);
  elements.insert(elements.end(), header.after_vertices.begin(), header.after_vertices.end());
  return elements;
}

// The values of an ascii body.
class AsciiValues {
 public:
  explicit AsciiValues(TextScanner& in) : in_(in) {}

  void skip_elements(const PlyElement& element) {
    if (element.properties.empty()) return;  // no values, no line
    for (std::uint64_t i = 0; i < element.count; ++i) begin(element, i);
  }

  void begin(const PlyElement& element, std::uint64_t index) {
    if (in_.next_content_line()) return;
    in_.fail("the file ends after " + std::to_string(index) + " of " +
             std::to_string(element.count) + " elements " + element.name);
  }

  void end() {
    if (!in_.at_line_end()) in_.fail("the line has more values than the header says");
  }

  double number(PlyType) { return in_.number<double>(); }
  std::uint64_t list_length(const PlyProperty&) { return in_.count(); }

  void skip(const PlyProperty& property) {
    for (std::uint64_t left = property.list_length ? in_.count() : 1; left > 0; --left) {
      if (in_.token().empty()) in_.fail("the line has fewer values than the header says");
    }
  }

  [[noreturn]] void fail(std::string_view reason) const { in_.fail(reason); }

 private:
  TextScanner& in_;
};

// The values of a binary body; faults are at the value taken last.
class BinaryValues {
 public:
  explicit BinaryValues(const PlyBinaryCursor& in) : in_(in), latest_(in) {}

  void skip_elements(const PlyElement& element) { in_.skip_elements(element); }
  void begin(const PlyElement& element, std::uint64_t index) {
    if (index == 0) in_.require(element.count, least_size(element), "elements " + element.name);
  }
  void end() {}

  double number(PlyType type) {
    latest_.emplace(in_);
    return in_.number(type);
  }
  std::uint64_t list_length(const PlyProperty& list) {
    latest_.emplace(in_);
    return in_.list_length(list);
  }
  void skip(const PlyProperty& property) { in_.skip(property); }

  [[noreturn]] void fail(std::string_view reason) const { latest_->fail(reason); }

 private:
  PlyBinaryCursor in_;
  std::optional<PlyBinaryCursor> latest_;  // behind an optional, for it cannot be assigned
};

// Adds the triangles of the body to a mesh that has its points.
template <typename Values>
class FaceParser {
 public:
  FaceParser(Values in, TriangleMesh& mesh)
      : in_(in), vertices_(mesh.points.size()), fan_(mesh.triangles) {}

  void parse(const PlyElement& element) {
    if (!is_face(element)) return in_.skip_elements(element);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      in_.begin(element, i);
      for (const PlyProperty& property : element.properties) {
        if (is_corner_list(property)) {
          parse_corners(property);
        } else {
          in_.skip(property);
        }
      }
      in_.end();
    }
  }

 private:
  void parse_corners(const PlyProperty& property) {
    for (std::uint64_t left = in_.list_length(property); left > 0; --left) {
      const double index = in_.number(property.type);
      if (!(index >= 0) || index >= static_cast<double>(vertices_) || index != std::floor(index)) {
        in_.fail(no_such_vertex(number_text(index), vertices_));
      }
      fan_.add(static_cast<std::uint32_t>(index));
    }
    if (const auto fault = fan_.finish()) in_.fail(*fault);
  }

  Values in_;
  std::size_t vertices_;
  PolygonFan fan_;
};

template <typename Values>
void parse_faces(const std::vector<PlyElement>& elements, Values in, TriangleMesh& mesh) {
  FaceParser parser(in, mesh);
  for (const PlyElement& element : elements) parser.parse(element);
}

void check_faces(const std::vector<PlyElement>& elements, const TextScanner& in) {
  for (const PlyElement& element : elements) {
    if (element.name == "tristrips" && element.count > 0) in.fail("triangle strips are not read");
  }
  if (std::ranges::none_of(elements, is_face)) {
    in.fail("the header has no element face with a list vertex_indices");
  }
}

}  // namespace

MeshFile parse_ply_mesh(std::string_view content, const std::filesystem::path& path) {
  PointFile vertices = parse_ply_points(content, path);
  MeshFile file{{std::move(vertices.points), {}}, vertices.precision};
  constexpr TextDialect kDialect = {.separators = " \t", .comments = {}};
  TextScanner in(content, path, kDialect);
  const PlyHeader header = parse_ply_header(in);
  const std::vector<PlyElement> elements = all_elements(header);
  check_faces(elements, in);
  if (header.format == PlyFormat::kAscii) {
    parse_faces(elements, AsciiValues(in), file.mesh);
  } else {
    const std::size_t begin = ply_body_begin(content, in.next_offset());
    const PlyBinaryCursor cursor(content, begin, byte_order(header.format), path);
    parse_faces(elements, BinaryValues(cursor), file.mesh);
  }
  return file;
}

}  // namespace tetsculpt
