#include "tools/outputs.h"

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "io/atomic_file.h"
#include "io/graph_writer.h"
#include "io/picture.h"
#include "io/png_writer.h"
#include "io/tetrahedra_writer.h"
#include "tools/surface_file.h"
#include "tools/viewer.h"

namespace tetsculpt::cli {
namespace {

std::filesystem::path graph_file(const Arguments& arguments, std::string_view name) {
  std::filesystem::path file = arguments.graphs;
  return file.concat("_").concat(name).concat(".ply");
}

void try_output(const std::filesystem::path& file) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(file, ignored);
  // Opening a pipe or a device is more than a try.
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
      !std::filesystem::is_directory(status)) {
    return;
  }
  const AtomicFile without_commit(file);
}

}  // namespace

void try_outputs(const Arguments& arguments) {
  for (const auto& file : {arguments.output, arguments.picture, arguments.viewer,
                           arguments.tetrahedra, arguments.stats_file}) {
    if (!file.empty() && file != "-") try_output(file);
  }
  if (!arguments.graphs.empty()) try_output(graph_file(arguments, "emst"));
}

void write_text(const std::string& text, const std::filesystem::path& file) {
  AtomicFile out(file);
  out.write(text);
  out.commit();
}

std::vector<std::string> write_outputs(const Arguments& arguments, const PointFile& file,
                                       const Reconstruction& result, const Topology& topology,
                                       std::span<const std::size_t> index_in_file) {
  std::vector<std::string> lines = write_surface(arguments, file, result, index_in_file);
  if (!arguments.picture.empty()) {
    write_png(draw({.mesh = &result.mesh}, arguments.view), arguments.picture);
  }
  if (!arguments.viewer.empty()) write_viewer(arguments, file.points, result, topology);
  if (!arguments.graphs.empty()) {
    const auto& [points, emst, gabriel, egh] = result.graphs;
    write_graph(points, emst, file.precision, graph_file(arguments, "emst"));
    write_graph(points, gabriel, file.precision, graph_file(arguments, "gabriel"));
    write_graph(points, egh, file.precision, graph_file(arguments, "egh"));
  }
  if (!arguments.tetrahedra.empty()) write_tetrahedra(result.tetrahedra, arguments.tetrahedra);
  return lines;
}

}  // namespace tetsculpt::cli
