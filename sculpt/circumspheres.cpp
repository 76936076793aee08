#include "sculpt/circumspheres.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetsculpt {
namespace {

using Vec = Vec3<double>;

}  // namespace

Circumspheres::Circumspheres(std::span<const Point3> points, const TetComplex& complex)
    : points_(points), complex_(&complex) {
  balls_.reserve(complex.tet_count());
  for (std::uint32_t t = 0; t < complex.tet_count(); ++t) {
    balls_.push_back(complex.finite(TetId{t}) ? finite_ball(TetId{t}) : half_space(TetId{t}));
  }
}

Circumspheres::Ball Circumspheres::finite_ball(TetId t) const {
  const std::array<VertexId, 4>& v = complex_->vertices(t);
  const Point3& o = points_[+v[0]];
  const Vec a = from_to(o, points_[+v[1]]);
  const Vec b = from_to(o, points_[+v[2]]);
  const Vec c = from_to(o, points_[+v[3]]);
  const Vec bc = cross(b, c);
  const Vec sum = bc * dot(a, a) + cross(c, a) * dot(b, b) + cross(a, b) * dot(c, c);
  const Vec offset = sum * (1 / (2 * dot(a, bc)));
  const double radius = length(offset);
  return {as_vector(o) + offset, std::isfinite(radius) ? radius : HUGE_VAL};
}

Circumspheres::Ball Circumspheres::half_space(TetId t) const {
  const Facet hull = complex_->across(t, corner_of(complex_->vertices(t), kInfinite));
  const auto& facet = kFacetCorners[static_cast<std::size_t>(hull.corner)];
  const auto& v = complex_->vertices(hull.tet);
  std::array<VertexId, 3> c{v[facet[0]], v[facet[1]], v[facet[2]]};
  std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
  const Point3& o = points_[+c[0]];
  const Vec normal = cross(from_to(o, points_[+c[1]]), from_to(o, points_[+c[2]]));
  return {normal * (1 / length(normal)), 0};
}

double Circumspheres::overlap(TetId t, int corner) const {
  const Facet other = complex_->across(t, corner);
  const bool finite = complex_->finite(t);
  if (finite != complex_->finite(other.tet)) {
    return finite ? overlap_with_outside(t, corner, other.tet)
                  : overlap_with_outside(other.tet, other.corner, t);
  }
  if (!finite) return 1;
  const Ball& a = balls_[+std::min(t, other.tet)];
  const Ball& b = balls_[+std::max(t, other.tet)];
  const Vec d = from_to(a.centre, b.centre);
  const double cosine =
      (a.radius * a.radius + b.radius * b.radius - dot(d, d)) / (2 * a.radius * b.radius);
  return std::isfinite(cosine) ? std::clamp(cosine, -1.0, 1.0) : 0;
}

double Circumspheres::overlap_with_outside(TetId finite, int corner, TetId infinite) const {
  const auto& v = complex_->vertices(finite);
  const auto& facet = kFacetCorners[static_cast<std::size_t>(corner)];
  const VertexId first = std::min({v[facet[0]], v[facet[1]], v[facet[2]]});
  const Ball& ball = balls_[+finite];
  const double height =
      dot(from_to(as_vector(points_[+first]), ball.centre), balls_[+infinite].centre);
  const double cosine = height / ball.radius;
  return std::isfinite(cosine) ? std::clamp(cosine, -1.0, 1.0) : 0;
}

LargeArray<float> overlaps(const TetComplex& complex, const Circumspheres& spheres) {
  LargeArray<float> overlap(complex.triangle_count());
  for (std::uint32_t t = 0; t < complex.triangle_count(); ++t) {
    const Facet f = complex.facet(TriangleId{t});
    overlap[t] = static_cast<float>(spheres.overlap(f.tet, f.corner));
  }
  return overlap;
}

}  // namespace tetsculpt
