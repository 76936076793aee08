// On lattices, where everything is cospherical, the tetrahedra with empty perturbed spheres fill
// the hull exactly once, and edges and triangles with empty perturbed spheres are theirs.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "kernel/perturbation.h"
#include "kernel/predicates.h"
#include "tests/support/exact_predicates.h"
#include "tests/support/near_degenerate.h"

namespace tetsculpt {
namespace {

using Lattice = std::vector<Point3>;

/// {0..x} * {0..y} * {0..z}, turned by an integer quaternion.
Lattice lattice(std::int64_t x, std::int64_t y, std::int64_t z,
                const std::array<std::int64_t, 4>& quaternion) {
  Lattice points;
  for (std::int64_t i = 0; i < (x + 1) * (y + 1) * (z + 1); ++i) {
    const near_degenerate::Vector v = near_degenerate::rotated(
        quaternion, {i / ((y + 1) * (z + 1)), i / (z + 1) % (y + 1), i % (z + 1)});
    points.push_back({double(v[0]), double(v[1]), double(v[2])});
  }
  return points;
}

/// No point other than the corners is inside.
template <class Inside>
bool empty(const Lattice& points, std::vector<std::size_t> corners, const Inside& inside) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::find(corners.begin(), corners.end(), i) != corners.end()) continue;
    if (inside(points[i])) return false;
  }
  return true;
}

struct Delaunay {
  std::int64_t six_volumes = 0;
  std::set<std::vector<std::size_t>> faces;  // edges and triangles, corners ascending
};

void add_tetrahedron(Delaunay& delaunay, const std::array<std::size_t, 4>& corners) {
  for (std::size_t mask = 1; mask < 15; ++mask) {
    std::vector<std::size_t> face;
    for (std::size_t i = 0; i < 4; ++i) {
      if ((mask >> i & 1) != 0) face.push_back(corners[i]);
    }
    delaunay.faces.insert(face);
  }
}

Delaunay brute_force_delaunay(const Lattice& points) {
  Delaunay delaunay;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (std::size_t k = j + 1; k < n; ++k) {
        for (std::size_t l = k + 1; l < n; ++l) {
          Point3 a = points[i], b = points[j];
          const Point3 c = points[k], d = points[l];
          const Sign orientation = orient3d(a, b, c, d);
          if (orientation == Sign::kZero) continue;
          if (orientation == Sign::kNegative) std::swap(a, b);
          const auto inside = [&](const Point3& p) { return in_perturbed_sphere(a, b, c, d, p); };
          if (!empty(points, {i, j, k, l}, inside)) continue;
          add_tetrahedron(delaunay, {i, j, k, l});
          delaunay.six_volumes += exact::six_volumes(a, b, c, d);
        }
      }
    }
  }
  return delaunay;
}

/// Counts the edges and triangles with empty spheres, and those of them that the tetrahedra lack.
struct EmptySpheres {
  int edges = 0, triangles = 0, missing = 0;
};

EmptySpheres empty_spheres(const Lattice& points, const Delaunay& delaunay) {
  EmptySpheres found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const Point3 &a = points[i], &b = points[j];
      if (empty(points, {i, j},
                [&](const Point3& p) { return in_perturbed_diametral_sphere(a, b, p); })) {
        ++found.edges;
        found.missing += !delaunay.faces.contains({i, j});
      }
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        const Point3& c = points[k];
        if (collinear(a, b, c)) continue;
        if (empty(points, {i, j, k},
                  [&](const Point3& p) { return in_perturbed_equatorial_sphere(a, b, c, p); })) {
          ++found.triangles;
          found.missing += !delaunay.faces.contains({i, j, k});
        }
      }
    }
  }
  return found;
}

void check_lattice(const Lattice& points, std::int64_t six_volumes) {
  const Delaunay delaunay = brute_force_delaunay(points);
  CHECK(delaunay.six_volumes == six_volumes);
  const EmptySpheres found = empty_spheres(points, delaunay);
  CHECK(found.missing == 0);
  CHECK(found.edges >= int(points.size()) - 1);
  CHECK(found.triangles > 0);
}

TEST_CASE("axis-parallel lattices") {
  check_lattice(lattice(1, 1, 1, {1, 0, 0, 0}), 6);
  check_lattice(lattice(2, 2, 2, {1, 0, 0, 0}), 6 * 8);
  check_lattice(lattice(3, 2, 1, {1, 0, 0, 0}), 6 * 6);
}

TEST_CASE("turned lattices, with other lexicographic orders") {
  check_lattice(lattice(1, 1, 1, {1, 2, -3, 4}), 6 * 30 * 30 * 30);
  check_lattice(lattice(2, 2, 2, {1, 1, 0, -2}), 6 * 8 * 6 * 6 * 6);
  check_lattice(lattice(2, 2, 2, {3, 0, 0, 1}), 6 * 8 * 10 * 10 * 10);
  check_lattice(lattice(3, 2, 1, {2, -1, 1, 0}), 6 * 6 * 6 * 6 * 6);
}

}  // namespace
}  // namespace tetsculpt
