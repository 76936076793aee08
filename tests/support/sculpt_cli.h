#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/point.h"
#include "kernel/triangle_mesh.h"
#include "tests/support/io_files.h"

/// Running the command line program. Needs TETSCULPT_CLI, its path.
namespace tetsculpt::testing {

/// What a run of the program left.
struct Run {
  int status = -1;
  std::string out;
  std::string err;
};

/// Runs the program with these words in `dir`, which also takes the two streams while it runs.
/// `before` is shell text that precedes the program; `redirection` follows the words.
Run run(const TempDir& dir, const std::vector<std::string>& words, std::string_view before = "",
        std::string_view redirection = "");

/// The names of the files in a directory, ascending.
std::vector<std::string> names_in(const TempDir& dir);

/// One line `x y z` per point, to the last bit.
std::string xyz(const std::vector<Point3>& points);

/// The mesh in an OFF file as the program writes it.
TriangleMesh mesh_of_off(const std::filesystem::path& path);

}  // namespace tetsculpt::testing
