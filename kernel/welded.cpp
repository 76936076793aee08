#include "kernel/welded.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetsculpt {
namespace {

/// A place under a total order that any bits have.
struct Place {
  std::array<std::uint64_t, 3> bits;
  std::uint32_t index;
};

std::uint64_t bits_of(double x) { return std::bit_cast<std::uint64_t>(x + 0.0); }  // no -0.0

std::vector<Place> sorted_places(const std::vector<Point3>& points) {
  std::vector<Place> places(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Point3& p = points[i];
    places[i] = {{bits_of(p.x), bits_of(p.y), bits_of(p.z)}, i};
  }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return a.bits != b.bits ? a.bits < b.bits : a.index < b.index;
  });
  return places;
}

}  // namespace

TriangleMesh welded(TriangleMesh mesh) {
  std::vector<std::uint32_t> to(mesh.points.size());
  const std::vector<Place> places = sorted_places(mesh.points);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool first = i == 0 || places[i].bits != places[i - 1].bits;
    to[places[i].index] = first ? places[i].index : to[places[i - 1].index];
  }
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < to.size(); ++i) {
    if (to[i] == i) {
      mesh.points[kept] = mesh.points[i];
      to[i] = kept++;
    } else {
      to[i] = to[to[i]];  // the first of them has its new number
    }
  }
  mesh.points.resize(kept);
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& v : triangle) v = to[v];
  }
  return mesh;
}

}  // namespace tetsculpt
