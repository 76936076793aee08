#include "kernel/first_simplex.h"

#include <utility>

#include "kernel/predicates.h"

namespace tetsculpt {

FirstSimplex first_simplex(std::span<const Point3> points) {
  FirstSimplex simplex;
  const auto corner = [&](int i) -> const Point3& {
    return points[simplex.corners[static_cast<std::size_t>(i)]];
  };
  const auto extends = [&](const Point3& p) {
    switch (simplex.size) {
      case 0:
        return true;
      case 1:
        return !(p == corner(0));
      case 2:
        return !collinear(corner(0), corner(1), p);
      default:
        return orient3d(corner(0), corner(1), corner(2), p) != Sign::kZero;
    }
  };
  for (std::uint32_t i = 0; i < points.size() && simplex.size < 4; ++i) {
    if (extends(points[i])) simplex.corners[static_cast<std::size_t>(simplex.size++)] = i;
  }
  if (simplex.size == 4 &&
      orient3d(corner(0), corner(1), corner(2), corner(3)) == Sign::kNegative) {
    std::swap(simplex.corners[0], simplex.corners[1]);
  }
  return simplex;
}

}  // namespace tetsculpt
