#include "bench/surface_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

#include "kernel/vec3.h"

namespace tetsculpt::bench {
namespace {

using Vec = Vec3<double>;
using Corners = std::array<Point3, 3>;

Vec from_to(const Point3& a, const Point3& b) { return {b.x - a.x, b.y - a.y, b.z - a.z}; }

double length(const Vec& a) { return std::sqrt(dot(a, a)); }

Corners corners(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  return {mesh.points[triangle[0]], mesh.points[triangle[1]], mesh.points[triangle[2]]};
}

double area(const Corners& c) {
  return length(cross(from_to(c[0], c[1]), from_to(c[0], c[2]))) / 2;
}

double smallest_angle(const Corners& c) {
  double smallest = std::numbers::pi;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec a = from_to(c[i], c[(i + 1) % 3]);
    const Vec b = from_to(c[i], c[(i + 2) % 3]);
    smallest = std::min(smallest, std::atan2(length(cross(a, b)), dot(a, b)));
  }
  return smallest;
}

Point3 place(const Corners& c, double u, double v) {
  const double w = 1 - u - v;
  return {w * c[0].x + u * c[1].x + v * c[2].x, w * c[0].y + u * c[1].y + v * c[2].y,
          w * c[0].z + u * c[1].z + v * c[2].z};
}

/// Points compare by their coordinates: mesh and complex number them differently.
using Place = std::tuple<double, double, double>;
using Edge = std::pair<Place, Place>;

Edge edge(const Point3& a, const Point3& b) {
  const Place p{a.x, a.y, a.z};
  const Place q{b.x, b.y, b.z};
  return p < q ? Edge{p, q} : Edge{q, p};
}

}  // namespace

double surface_area(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& triangle : mesh.triangles) sum += area(corners(mesh, triangle));
  return sum;
}

std::size_t sharp_triangles(const TriangleMesh& mesh) {
  return static_cast<std::size_t>(
      std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& triangle) {
        return smallest_angle(corners(mesh, triangle)) < std::numbers::pi / 18;
      }));
}

DistanceToTruth distance_to_truth(const TriangleMesh& mesh,
                                  const std::function<double(const Point3&)>& distance) {
  constexpr int kSteps = 8;
  DistanceToTruth result;
  double weight = 0;
  for (const auto& triangle : mesh.triangles) {
    const Corners c = corners(mesh, triangle);
    const double share = area(c) / (kSteps * (kSteps + 1) / 2);
    for (int i = 0; i < kSteps; ++i) {
      for (int j = 0; i + j < kSteps; ++j) {
        const double d = distance(place(c, (i + 1.0 / 3) / kSteps, (j + 1.0 / 3) / kSteps));
        result.largest = std::max(result.largest, d);
        result.mean += share * d;
        weight += share;
      }
    }
  }
  if (weight > 0) result.mean /= weight;
  return result;
}

std::size_t tree_edges_off(const PaperStages& stages, const TriangleMesh& mesh) {
  std::set<Edge> on;
  for (const auto& [a, b, c] : mesh.triangles) {
    on.insert(edge(mesh.points[a], mesh.points[b]));
    on.insert(edge(mesh.points[b], mesh.points[c]));
    on.insert(edge(mesh.points[c], mesh.points[a]));
  }
  return static_cast<std::size_t>(
      std::count_if(stages.tree.begin(), stages.tree.end(), [&](EdgeId e) {
        const auto [a, b] = stages.complex.vertices(e);
        return !on.contains(edge(stages.distinct.points[+a], stages.distinct.points[+b]));
      }));
}

}  // namespace tetsculpt::bench
