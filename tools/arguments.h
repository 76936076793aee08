#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "io/mesh_format.h"
#include "io/picture.h"
#include "io/ply_writer.h"
#include "io/point_format.h"
#include "sculpt/reconstruct.h"

/// The command line of `tetsculpt`.
namespace tetsculpt::cli {

enum class Action { kReconstruct, kHelp, kVersion, kManual, kCompletion };

struct Arguments {
  Action action = Action::kReconstruct;
  std::filesystem::path input;   ///< "-": standard input
  std::filesystem::path output;  ///< "-": standard output
  std::optional<PointFormat> input_format;
  std::optional<MeshFormat> output_format;
  std::filesystem::path picture;  ///< empty: none; so below
  std::filesystem::path viewer;
  std::filesystem::path graphs;  ///< what the names of the graphs' files begin with
  std::filesystem::path tetrahedra;
  View view;
  bool view_given = false;
  ReconstructOptions options;
  bool quiet = false;
  bool verbose = false;
  bool progress = false;  ///< however quick the work is
  bool stats = false;
  std::filesystem::path stats_file;  ///< empty: standard output
  bool skip_invalid = false;
  bool attributes = true;  ///< of the input go along with the vertices
  bool normals = false;    ///< of the surface go along, too
  PlyEncoding ply_encoding = PlyEncoding::kBinary;
  bool dry_run = false;

  bool reads_standard_input() const { return input == "-"; }
  bool writes_standard_output() const { return output == "-"; }
};

/// A command line that makes no sense; what() says why.
class UsageError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Parses the words after the program's name by the table of tools/options.h. Throws UsageError.
Arguments parse_arguments(std::span<const char* const> words);

}  // namespace tetsculpt::cli
