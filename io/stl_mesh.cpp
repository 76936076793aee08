#include "io/stl_mesh.h"

#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/byte_order.h"
#include "io/io_error.h"
#include "io/polygon_fan.h"
#include "io/stl_reader.h"
#include "io/text_scanner.h"
#include "kernel/welded.h"

namespace tetsculpt {
namespace {

constexpr std::size_t kHeader = 80;  // and the count after it
constexpr std::size_t kBodyBegin = kHeader + 4;
constexpr std::size_t kRecord = 50;

std::uint32_t announced(std::string_view content) {
  return load_number<std::uint32_t>(content.data() + kHeader, std::endian::little);
}

bool is_binary(std::string_view content) {
  if (content.size() < kBodyBegin) return false;
  return content.size() == kBodyBegin + kRecord * std::uint64_t{announced(content)};
}

std::string lowered(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

/// A triangle of its own for every three points.
TriangleMesh soup(std::vector<Point3> corners) {
  TriangleMesh mesh{std::move(corners), {}};
  mesh.triangles.reserve(mesh.points.size() / 3);
  for (std::uint32_t v = 0; v < mesh.points.size(); v += 3) {
    mesh.triangles.push_back({v, v + 1, v + 2});
  }
  return mesh;
}

// facet normal nx ny nz / outer loop / vertex x y z ... / endloop / endfacet, a line each.
class TextParser {
 public:
  TextParser(std::string_view text, const std::filesystem::path& path)
      : in_(text, path, kDialect), fan_(mesh_.triangles) {}

  TriangleMesh parse() && {
    expect_line("solid");
    while (in_.next_content_line()) {
      const std::string word = lowered(in_.token());
      if (word == "facet") {
        parse_facet();
      } else if (word != "endsolid" && word != "solid") {
        in_.fail("expected facet or endsolid");
      } else {
        open_ = word == "solid";
      }
    }
    if (open_) in_.fail("the file ends without endsolid");
    return std::move(mesh_);
  }

 private:
  static constexpr TextDialect kDialect{};

  void expect_line(std::string_view word) {
    if (!in_.next_content_line()) in_.fail("the file ends before " + std::string(word));
    if (lowered(in_.token()) != word) in_.fail("expected " + std::string(word));
  }

  void parse_facet() {
    if (!open_) in_.fail("a facet outside of a solid");
    expect_line("outer");
    std::string word;
    for (;;) {
      if (!in_.next_content_line()) in_.fail("the file ends within a loop");
      word = lowered(in_.token());
      if (word != "vertex") break;
      fan_.add(static_cast<std::uint32_t>(mesh_.points.size()));
      mesh_.points.push_back(in_.point());
    }
    if (word != "endloop") in_.fail("expected vertex or endloop");
    if (const auto fault = fan_.finish()) in_.fail(*fault);
    expect_line("endfacet");
  }

  TextScanner in_;
  TriangleMesh mesh_;
  PolygonFan fan_;
  bool open_ = true;
};

}  // namespace

MeshFile parse_stl_mesh(std::string_view content, const std::filesystem::path& path) {
  if (is_binary(content)) {
    return {welded(soup(parse_stl_points(content, path).points)), Precision::kSingle};
  }
  if (lowered(content.substr(0, 5)) == "solid") {
    return {welded(TextParser(content, path).parse()), Precision::kDouble};
  }
  if (content.size() < kBodyBegin) throw IoError(path, "not an STL file: too short");
  throw IoError(path, ByteOffset{kHeader},
                std::to_string(announced(content)) + " triangles of 50 bytes announced, " +
                    std::to_string(content.size() - kBodyBegin) + " bytes behind it");
}

}  // namespace tetsculpt
