#include "tools/surface_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <string_view>

#include "io/vertex_normals.h"
#include "io/write_mesh.h"

namespace tetsculpt::cli {
namespace {

void add_line(std::vector<std::string>& lines, const std::string& text,
              const std::vector<std::string>& names) {
  if (names.empty()) return;
  lines.push_back(text);
  for (const std::string& name : names) lines.back().append(" ").append(name);
}

/// Puts the surface's own normals in the place of any others.
void replace_normals(const TriangleMesh& mesh, std::vector<Attribute>& attributes,
                     std::vector<std::string>& lines) {
  constexpr std::array<std::string_view, 3> kNames = {"nx", "ny", "nz"};
  const std::size_t others = std::erase_if(attributes, [&](const Attribute& attribute) {
    return std::ranges::find(kNames, attribute.name) != kNames.end();
  });
  if (others > 0) lines.push_back("--normals replaces the normals of the input");
  std::ranges::move(vertex_normal_attributes(mesh), std::back_inserter(attributes));
}

}  // namespace

std::vector<Attribute> vertex_attributes(std::span<const Attribute> of_file,
                                         const Reconstruction& result,
                                         std::span<const std::size_t> index_in_file) {
  std::vector<std::uint32_t> first(result.mesh.points.size());
  for (std::size_t i = result.vertex_of_input.size(); i-- > 0;) {
    const std::uint32_t vertex = result.vertex_of_input[i];
    if (vertex == Reconstruction::kHidden) continue;
    first[vertex] = static_cast<std::uint32_t>(index_in_file[i]);
  }
  std::vector<Attribute> of_vertices;
  for (const Attribute& attribute : of_file) of_vertices.push_back(gathered(attribute, first));
  return of_vertices;
}

std::vector<std::string> write_surface(const Arguments& arguments, const PointFile& file,
                                       const Reconstruction& result,
                                       std::span<const std::size_t> index_in_file) {
  std::vector<std::string> lines;
  std::vector<Attribute> attributes;
  if (arguments.attributes) {
    attributes = vertex_attributes(file.attributes, result, index_in_file);
  }
  if (arguments.normals) replace_normals(result.mesh, attributes, lines);
  const WriteMeshOptions options{.format = arguments.output_format,
                                 .precision = file.precision,
                                 .ply_encoding = arguments.ply_encoding,
                                 .attributes = attributes};
  const bool to_standard_output = arguments.writes_standard_output();
  const WriteReport report = to_standard_output
                                 ? write_mesh_to_standard_output(result.mesh, options)
                                 : write_mesh(result.mesh, arguments.output, options);
  const std::string name = to_standard_output ? "standard output" : arguments.output.string();
  add_line(lines, name + ": rounded to 32-bit floats:", report.rounded);
  add_line(lines, name + ": not in this format:", report.dropped);
  return lines;
}

}  // namespace tetsculpt::cli
