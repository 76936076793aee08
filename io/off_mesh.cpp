#include "io/off_mesh.h"

#include <cstdint>
#include <string>

#include "io/off_reader.h"
#include "io/polygon_fan.h"
#include "io/text_scanner.h"

namespace tetsculpt {
namespace {

void parse_face(TextScanner& in, std::size_t vertices, PolygonFan& fan) {
  for (std::uint64_t left = in.count(); left > 0; --left) {
    const std::uint64_t index = in.count();
    if (index >= vertices) in.fail(no_such_vertex(std::to_string(index), vertices));
    fan.add(static_cast<std::uint32_t>(index));
  }
  if (const auto fault = fan.finish()) in.fail(*fault);
}

}  // namespace

MeshFile parse_off_mesh(std::string_view text, const std::filesystem::path& path) {
  constexpr TextDialect kDialect;
  MeshFile file{{parse_off_points(text, path).points, {}}, Precision::kDouble};
  TextScanner in(text, path, kDialect);
  const OffCounts counts = parse_off_counts(in);
  if (!counts.faces) in.fail("the number of faces is missing");
  for (std::uint64_t i = 0; i < counts.vertices; ++i) in.next_content_line();
  PolygonFan fan(file.mesh.triangles);
  for (std::uint64_t i = 0; i < *counts.faces; ++i) {
    if (!in.next_content_line()) {
      in.fail("the file ends after " + std::to_string(i) + " of " + std::to_string(*counts.faces) +
              " faces");
    }
    parse_face(in, file.mesh.points.size(), fan);
  }
  return file;
}

}  // namespace tetsculpt
