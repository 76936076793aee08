// Any bytes are read as a mesh whose indices are those of points, or refused with an IoError; and
// what is read can be judged. TETSCULPT_FUZZ_FORMAT names the format.
#include "io/read_mesh.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "io/io_error.h"
#include "kernel/distinct_points.h"
#include "kernel/mesh_shape.h"
#include "tests/fuzz/require.h"

namespace tetsculpt::fuzz {
namespace {

void check(const TriangleMesh& mesh) {
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) require(v < mesh.points.size(), "index out of range");
  }
  const MeshReport report = judge(mesh);
  if (invalid_points(mesh.points).count > 0) return;
  try {
    measure(mesh, report);
  } catch (const InvalidPoint&) {
  }
}

void run(std::string_view content) {
  const auto format = mesh_source_named(TETSCULPT_FUZZ_FORMAT);
  require(format.has_value(), "no such format");
  try {
    check(parse_mesh(content, "input", {.format = format}).mesh);
  } catch (const IoError&) {
  }
}

}  // namespace
}  // namespace tetsculpt::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tetsculpt::fuzz::run({reinterpret_cast<const char*>(data), size});
  return 0;
}
