#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "kernel/mesh_points.h"
#include "kernel/mesh_report.h"
#include "kernel/mesh_shape.h"

/// What `check` says about a mesh.
namespace tetsculpt::cli {

struct CheckFacts {
  std::string file;
  MeshReport report;
  Faults<std::uint32_t> invalid_points;
  std::optional<MeshShape> shape;  ///< none if there are invalid points
  std::size_t welded = 0;          ///< points that were joined to others before all else

  /// Of --points.
  struct Points {
    std::string file;
    std::size_t given = 0;
    Faults<std::uint32_t> invalid;
    bool as_floats = false;  ///< rounded to floats first, since the mesh's are
    PointsOnMesh on_mesh;
  };
  std::optional<Points> points;
};

/// A closed, oriented manifold that faces outward, and nothing wrong with it.
bool flawless(const CheckFacts& facts);

/// For people, some lines.
std::string check_text(const CheckFacts& facts);

/// One JSON object on one line.
std::string check_json(const CheckFacts& facts);

}  // namespace tetsculpt::cli
