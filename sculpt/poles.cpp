// N. Amenta, S. Choi, R. K. Kolluri, "The power crust", Solid Modeling 2001. At a vertex of the
// convex hull the first pole is at infinity, along the mean normal of its hull triangles.
#include "sculpt/poles.h"

#include <algorithm>
#include <cmath>

namespace tetsculpt {
namespace {

using Vec = Vec3<double>;

/// The first pole and the axis towards it.
PolePair first_pole(const Vec& p, std::span<const TetId> star, const TetComplex& complex,
                    const Circumspheres& spheres) {
  PolePair pair;
  Vec outward{0, 0, 0};
  bool on_hull = false;
  double farthest = -1;
  for (const TetId t : star) {
    if (!complex.finite(t)) {
      outward = outward + spheres.outward(t);
      if (!on_hull) pair.first = t;
      on_hull = true;
    } else if (!on_hull && std::isfinite(spheres.radius(t)) && spheres.radius(t) > farthest) {
      farthest = spheres.radius(t);
      pair.first = t;
    }
  }
  const Vec axis = on_hull ? outward : from_to(p, spheres.centre(pair.first));
  pair.axis = axis * (1 / length(axis));
  return pair;
}

}  // namespace

std::vector<PolePair> poles(std::span<const Point3> points, const TetComplex& complex,
                            const VertexStars& stars, const Circumspheres& spheres) {
  std::vector<PolePair> pairs(points.size());
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    const Vec p = as_vector(points[v]);
    const auto star = stars(VertexId{v});
    PolePair& pair = pairs[v] = first_pole(p, star, complex, spheres);
    double farthest = -1;
    for (const TetId t : star) {
      if (!complex.finite(t) || !std::isfinite(spheres.radius(t))) continue;
      const Vec to = from_to(p, spheres.centre(t));
      const double along = dot(to, pair.axis);
      if (along < 0 && spheres.radius(t) > farthest) {
        farthest = spheres.radius(t);
        pair.second = t;
        pair.strength = std::min(-along / length(to), 1.0);
      }
    }
  }
  return pairs;
}

}  // namespace tetsculpt
