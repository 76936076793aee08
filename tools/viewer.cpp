#include "tools/viewer.h"

#include <cstddef>
#include <string>
#include <vector>

#include "io/viewer_writer.h"
#include "tools/options.h"

namespace tetsculpt::cli {
namespace {

/// With a comma between groups of three digits.
std::string grouped(std::size_t n) {
  const std::string digits = std::to_string(n);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string method_name(const ReconstructOptions& options) {
  if (options.method != Method::kPaper) return name(options.method);
  return name(options.method) + ", " + name(options.criterion);
}

}  // namespace

void write_viewer(const Arguments& arguments, std::span<const Point3> points,
                  const Reconstruction& result, const Topology& topology) {
  std::vector<Point3> hidden;
  for (const std::size_t i : result.hidden) hidden.push_back(points[i]);
  const auto& counts = result.counts;
  ViewerScene scene{.title = arguments.input.filename().string(),
                    .facts = {{"Method", method_name(arguments.options)},
                              {"Points", grouped(counts.vertices)},
                              {"Triangles", grouped(result.mesh.triangles.size())},
                              {"Components", grouped(topology.components)},
                              {"Genus", grouped(topology.genus)},
                              {"Delaunay tetrahedra", grouped(counts.tetrahedra)}},
                    .points = result.mesh.points,
                    .hidden = hidden,
                    .record = &result.record,
                    .emst_edges = result.graphs.emst.edges,
                    .egh_triangles = result.graphs.egh.triangles};
  tetsculpt::write_viewer(scene, arguments.viewer, {.view = arguments.view});
}

}  // namespace tetsculpt::cli
