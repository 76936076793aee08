#include "tools/outputs.h"

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "io/atomic_file.h"
#include "io/graph_writer.h"
#include "io/io_error.h"
#include "io/picture.h"
#include "io/png_writer.h"
#include "io/write_mesh.h"

namespace tetsculpt::cli {
namespace {

std::filesystem::path graph_file(const Arguments& arguments, std::string_view name) {
  std::filesystem::path file = arguments.graphs;
  return file.concat("_").concat(name).concat(".ply");
}

// TO BE WIRED: the writer of meshes to standard output.
void write_to_standard_output(const TriangleMesh&, const WriteMeshOptions&) {
  throw IoError("standard output", "meshes can't be written there yet");
}

// TO BE WIRED: the writer of tetrahedra, write_tetrahedra(mesh, path).
void write_tetrahedra_file(const TetMesh&, const std::filesystem::path& path) {
  throw IoError(path, "tetrahedra can't be written yet");
}

void write_surface(const Arguments& arguments, const TriangleMesh& mesh, Precision precision) {
  const WriteMeshOptions options{.format = arguments.output_format, .precision = precision};
  if (arguments.writes_standard_output()) return write_to_standard_output(mesh, options);
  write_mesh(mesh, arguments.output, options);
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
  for (const auto& file :
       {arguments.output, arguments.picture, arguments.tetrahedra, arguments.stats_file}) {
    if (!file.empty() && file != "-") try_output(file);
  }
  if (!arguments.graphs.empty()) try_output(graph_file(arguments, "emst"));
}

void write_text(const std::string& text, const std::filesystem::path& file) {
  AtomicFile out(file);
  out.write(text);
  out.commit();
}

void write_outputs(const Arguments& arguments, const Reconstruction& result, Precision precision) {
  write_surface(arguments, result.mesh, precision);
  if (!arguments.picture.empty()) {
    write_png(draw({.mesh = &result.mesh}, arguments.view), arguments.picture);
  }
  if (!arguments.graphs.empty()) {
    const auto& [points, emst, gabriel, egh] = result.graphs;
    write_graph(points, emst, precision, graph_file(arguments, "emst"));
    write_graph(points, gabriel, precision, graph_file(arguments, "gabriel"));
    write_graph(points, egh, precision, graph_file(arguments, "egh"));
  }
  if (!arguments.tetrahedra.empty()) {
    write_tetrahedra_file(result.tetrahedra, arguments.tetrahedra);
  }
}

}  // namespace tetsculpt::cli
