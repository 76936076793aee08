// N. Amenta, S. Choi, R. K. Kolluri, "The power crust", Solid Modeling 2001. At a vertex of the
// convex hull the first pole is at infinity, along the mean normal of its hull triangles.
#include "sculpt/poles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tetsculpt {
namespace {

using Vec = Vec3<double>;

constexpr TetId kNone{0xffffffffu};

/// Radii of what has been found so far, -1 for nothing.
using Radii = LargeArray<double>;

/// First poles: at infinity, or the largest sphere. Axes are left unset in the second case, and are
/// sums of normals in the first.
void find_first(const TetComplex& complex, const Circumspheres& spheres,
                LargeArray<PolePair>& pairs) {
  Radii largest(pairs.size(), -1);
  for (std::size_t i = complex.finite_tet_count(); i < complex.tet_count(); ++i) {
    const TetId t{static_cast<std::uint32_t>(i)};
    for (const VertexId v : complex.vertices(t)) {
      if (v == kInfinite) continue;
      if (largest[+v] < 0) pairs[+v].first = t;
      largest[+v] = HUGE_VAL;
      pairs[+v].axis = pairs[+v].axis + spheres.outward(t);
    }
  }
  for (std::uint32_t i = 0; i < complex.finite_tet_count(); ++i) {
    const TetId t{i};
    const double radius = spheres.radius(t);
    if (!std::isfinite(radius)) continue;
    for (const VertexId v : complex.vertices(t)) {
      if (radius <= largest[+v]) continue;
      largest[+v] = radius;
      pairs[+v].first = t;
    }
  }
}

/// Second poles; `largest` has their radii in the end.
void find_second(std::span<const Point3> points, const TetComplex& complex,
                 const Circumspheres& spheres, LargeArray<PolePair>& pairs) {
  Radii largest(pairs.size(), 0);
  for (std::uint32_t i = 0; i < complex.finite_tet_count(); ++i) {
    const TetId t{i};
    const double radius = spheres.radius(t);
    if (!std::isfinite(radius)) continue;
    for (const VertexId v : complex.vertices(t)) {
      if (radius <= largest[+v]) continue;
      PolePair& pair = pairs[+v];
      const double along = dot(from_to(as_vector(points[+v]), spheres.centre(t)), pair.axis);
      if (!(along < 0)) continue;
      largest[+v] = radius;
      pair.second = t;
      pair.strength = std::min(-along / radius, 1.0);
    }
  }
}

}  // namespace

LargeArray<PolePair> poles(std::span<const Point3> points, const TetComplex& complex,
                           const Circumspheres& spheres) {
  LargeArray<PolePair> pairs(points.size(), PolePair{kNone, kNone, {0, 0, 0}, 0});
  find_first(complex, spheres, pairs);
  for (std::size_t v = 0; v < points.size(); ++v) {
    PolePair& pair = pairs[v];
    if (pair.first == kNone) {  // every tetrahedron here is flat to rounding
      pair.first = complex.tet(VertexId{static_cast<std::uint32_t>(v)});
      continue;
    }
    const Vec axis = complex.finite(pair.first)
                         ? from_to(as_vector(points[v]), spheres.centre(pair.first))
                         : pair.axis;
    pair.axis = axis * (1 / length(axis));
  }
  find_second(points, complex, spheres, pairs);
  for (PolePair& pair : pairs) {
    if (pair.second == kNone) pair.second = pair.first;
  }
  return pairs;
}

}  // namespace tetsculpt
