#pragma once

#include <string>
#include <string_view>

#include "io/io_error.h"
#include "io/read_mesh.h"

/// Meshes from bytes.
namespace tetsculpt::testing {

/// What parse_mesh makes of a file `name` with this content.
inline MeshFile mesh_from(std::string_view name, std::string_view content) {
  return parse_mesh(content, std::string(name));
}

/// As refusal() of io_files.h, of meshes.
inline std::string mesh_refusal(std::string_view name, std::string_view content) {
  try {
    mesh_from(name, content);
  } catch (const IoError& error) {
    const std::string_view message = error.what();
    return std::string(message.substr(name.size() + (error.line() ? 1 : 2)));
  }
  return "read";
}

}  // namespace tetsculpt::testing
