#include "bench/dumbbell.h"

#include <cmath>
#include <numbers>

#include "support/point_sets.h"

namespace tetsculpt::bench {
namespace {

constexpr double kHalf = 0.7;  // the balls' centres are (+-kHalf, 0, 0)

}  // namespace

std::vector<Point3> dumbbell(double spacing, std::uint64_t seed) {
  std::vector<Point3> points;
  for (const double side : {-1.0, 1.0}) {
    const auto ball = point_sets::sphere(spacing, seed + (side > 0));
    for (const Point3& p : point_sets::translated(ball, {side * kHalf, 0, 0})) {
      if (side * p.x > 0) points.push_back(p);
    }
  }
  return points;
}

double distance_to_dumbbell(const Point3& p) {
  // By symmetry to the ball on p's own side: its nearest point, unless that lies in the other ball;
  // then the crease, a circle, is nearest.
  const double x = std::fabs(p.x);
  const double off_axis = std::hypot(p.y, p.z);
  const double from_centre = std::hypot(x - kHalf, off_axis);
  const double nearest_x = from_centre > 0 ? kHalf + (x - kHalf) / from_centre : kHalf + 1;
  if (nearest_x >= 0) return std::fabs(from_centre - 1);
  return std::hypot(x, off_axis - std::sqrt(1 - kHalf * kHalf));
}

double dumbbell_area() { return 2 * 2 * std::numbers::pi * (1 + kHalf); }

}  // namespace tetsculpt::bench
