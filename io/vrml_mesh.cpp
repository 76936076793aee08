// VRML97, ISO/IEC 14772-1:1997, annex A (grammar) and section 6.23 (IndexedFaceSet).
#include "io/vrml_mesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "io/polygon_fan.h"
#include "io/quoted.h"
#include "io/word_cursor.h"

namespace tetsculpt {
namespace {

constexpr std::string_view kSignature = "#VRML V2.0";

constexpr std::array<std::string_view, 11> kNotRead = {
    "Box",      "Cone",   "Cylinder", "Sphere",      "ElevationGrid", "Extrusion",
    "PointSet", "Inline", "PROTO",    "EXTERNPROTO", "IndexedLineSet"};

class VrmlParser {
 public:
  VrmlParser(std::string_view text, const std::filesystem::path& path)
      : in_(text, path, {.separators = " \t\r\n,", .marks = "{}[]\"", .comment = '#'}) {
    if (!text.starts_with(kSignature)) in_.fail("not a VRML 2.0 file");
  }

  MeshFile parse() && {
    std::string_view before;
    for (std::string_view word = in_.word(); !word.empty(); word = in_.word()) {
      if (word == "IndexedFaceSet") {
        parse_face_set();
      } else if (word == "TextureTransform") {
        skip_node();
      } else if (word == "translation" || word == "center") {
        check_field(word, word == "center" ? Neutral::kAnything : Neutral::kZeros);
      } else if (word == "scale") {
        check_field(word, Neutral::kOnes);
      } else if (word == "rotation") {
        check_rotation();
      } else if (std::ranges::count(kNotRead, word) > 0) {
        in_.fail(std::string(word) + " is not read");
      } else if (word == "USE" && (before == "geometry" || before == "[" || before == "children")) {
        in_.fail("instances (USE) are not read");
      }
      before = word;
    }
    if (!has_faces_) in_.fail("the file has no IndexedFaceSet with faces");
    return std::move(file_);
  }

 private:
  enum class Neutral { kZeros, kOnes, kAnything };

  void check_field(std::string_view name, Neutral neutral) {
    const Point3 value = in_.point();
    const double x = neutral == Neutral::kOnes ? 1 : 0;
    if (neutral == Neutral::kAnything || value == Point3{x, x, x}) return;
    in_.fail("a Transform with a " + std::string(name) + " is not read");
  }

  void check_rotation() {
    in_.point();
    if (in_.number() != 0) in_.fail("a Transform with a rotation is not read");
  }

  std::string_view inner_word() {
    const std::string_view word = in_.word();
    if (word.empty()) in_.fail("the file ends within a node");
    return word;
  }

  void expect(std::string_view expected) {
    const std::string_view word = inner_word();
    if (word != expected) in_.fail("expected " + quoted(expected) + ", found " + quoted(word));
  }

  // From before its brace to behind it.
  void skip_node() {
    expect("{");
    for (int depth = 1; depth > 0;) {
      const std::string_view word = inner_word();
      depth += word == "{" || word == "[" ? 1 : word == "}" || word == "]" ? -1 : 0;
    }
  }

  // Fields come in any order: the faces are added at the end of the node.
  void parse_face_set() {
    expect("{");
    base_ = static_cast<std::uint32_t>(file_.mesh.points.size());
    first_triangle_ = file_.mesh.triangles.size();
    WordCursor faces = in_;
    bool has_index = false;
    bool clockwise = false;
    int depth = 1;
    while (depth > 0) {
      const std::string_view word = inner_word();
      depth += word == "{" || word == "[" ? 1 : word == "}" || word == "]" ? -1 : 0;
      if (depth != 1) continue;
      if (word == "coord") parse_coordinates();
      if (word == "ccw") clockwise = inner_word() == "FALSE";
      if (word == "coordIndex") {
        if (std::exchange(has_index, true)) in_.fail("coordIndex for the second time");
        faces = in_;
      }
    }
    if (!has_index) return;
    const WordCursor behind = std::exchange(in_, faces);
    parse_faces();
    in_ = behind;
    if (!clockwise) return;
    for (std::size_t t = first_triangle_; t < file_.mesh.triangles.size(); ++t) {
      std::swap(file_.mesh.triangles[t][1], file_.mesh.triangles[t][2]);
    }
  }

  void parse_coordinates() {
    std::string_view word = inner_word();
    if (word == "DEF") {
      inner_word();
      word = inner_word();
    }
    if (word == "NULL") return;
    if (word != "Coordinate") in_.fail("expected a Coordinate node, found " + quoted(word));
    if (file_.mesh.points.size() > base_) in_.fail("coord for the second time");
    expect("{");
    while ((word = inner_word()) != "}") {
      if (word != "point") in_.fail("expected point, found " + quoted(word));
      if (in_.peek() != "[") {
        file_.mesh.points.push_back(in_.point());
        continue;
      }
      in_.word();
      while (in_.peek() != "]") file_.mesh.points.push_back(in_.point());
      in_.word();
    }
  }

  // The end of the last face, -1, may be missing.
  void parse_faces() {
    PolygonFan fan(file_.mesh.triangles);
    const std::size_t vertices = file_.mesh.points.size() - base_;
    expect("[");
    bool open = false;
    while (in_.peek() != "]") {
      const std::int64_t index = in_.integer();
      if (index < -1 || index >= static_cast<std::int64_t>(vertices)) {
        in_.fail(no_such_vertex(std::to_string(index), vertices));
      }
      open = index >= 0;
      if (open) {
        fan.add(static_cast<std::uint32_t>(index) + base_);
      } else {
        finish(fan);
      }
    }
    if (open) finish(fan);
  }

  void finish(PolygonFan& fan) {
    if (const auto fault = fan.finish()) in_.fail(*fault);
    has_faces_ = true;
  }

  WordCursor in_;
  MeshFile file_;
  std::uint32_t base_ = 0;  // first point of the face set
  std::size_t first_triangle_ = 0;
  bool has_faces_ = false;
};

}  // namespace

MeshFile parse_vrml_mesh(std::string_view text, const std::filesystem::path& path) {
  return VrmlParser(text, path).parse();
}

}  // namespace tetsculpt
