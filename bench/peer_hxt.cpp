// Gmsh's library has these functions but no header for them. What is declared here is how version
// 4.8 lays out its structures; another version of the library would have another name.
#include "bench/peer_hxt.h"

#include <cstdint>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>

namespace tetsculpt::bench {
namespace {

struct Mesh {
  double* coordinates;  ///< four per vertex, aligned; reordered
  std::uint32_t vertex_count;
  std::uint32_t vertex_room;
  std::uint32_t* corners;  ///< four per tetrahedron, the last of an infinite one kGhost
  std::uint64_t* neighbors;
  void* colors;
  void* flags;
  std::uint64_t tet_count;
  static constexpr std::uint32_t kGhost = 0xffffffffu;
  // And more, of which we need nothing.
};

struct Options {
  void* box = nullptr;
  void* sizes = nullptr;
  std::uint32_t vertices_in_mesh = 0;
  std::uint32_t first_to_insert = 0;
  double partitionability = 0;
  int perfect_delaunay = 1;
  int verbosity = 0;
  int reproducible = 0;
  int threads = 1;
};

extern "C" {
int hxtMeshCreate(Mesh** mesh);
int hxtMeshDelete(Mesh** mesh);
int hxtDelaunay(Mesh* mesh, Options* options);
}

void check(int status) {
  if (status < 0) throw std::runtime_error("HXT failed: status " + std::to_string(status));
}

}  // namespace

std::size_t hxt_tetrahedra(const std::vector<Point3>& points) {
  constexpr std::size_t kAlignment = 4096;
  Mesh* mesh = nullptr;
  check(hxtMeshCreate(&mesh));
  const std::size_t bytes = 4 * sizeof(double) * points.size();
  mesh->coordinates = static_cast<double*>(
      std::aligned_alloc(kAlignment, (bytes + kAlignment - 1) / kAlignment * kAlignment));
  if (!mesh->coordinates) throw std::bad_alloc();
  mesh->vertex_count = mesh->vertex_room = static_cast<std::uint32_t>(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3& p = points[i];
    double* const to = mesh->coordinates + 4 * i;
    to[0] = p.x;
    to[1] = p.y;
    to[2] = p.z;
    to[3] = 0;
  }
  Options options;
  check(hxtDelaunay(mesh, &options));
  std::size_t count = 0;
  for (std::uint64_t t = 0; t < mesh->tet_count; ++t) {
    count += mesh->corners[4 * t + 3] != Mesh::kGhost;
  }
  check(hxtMeshDelete(&mesh));
  return count;
}

}  // namespace tetsculpt::bench
