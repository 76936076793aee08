#pragma once

#include <string>
#include <vector>

#include "io/write_mesh.h"
#include "tests/support/sculpt_cli.h"

/// Runs of `tetsculpt check`.
namespace tetsculpt::testing {

/// On `mesh`, written to a file of this name, with more words.
inline Run check(const TempDir& dir, const TriangleMesh& mesh, std::vector<std::string> more = {},
                 const std::string& name = "m.off") {
  write_mesh(mesh, dir.path() / name);
  more.insert(more.begin(), {"check", name});
  return run(dir, more);
}

inline bool says(const Run& run, const std::string& text) {
  return run.out.find(text) != std::string::npos;
}

}  // namespace tetsculpt::testing
