// Minimal change of area: J.-D. Boissonnat, "Geometric structures for three-dimensional shape
// representation", ACM Transactions on Graphics 3(4), 1984, as cited by the paper: here the area of
// the faces that appear minus that of the faces that go, in absolute value. Gamma-indicator: R. C.
// Veltkamp, "Closed object boundaries from scattered points", LNCS 885, 1994: for a boundary face
// with circumradius r, of a tetrahedron with circumradius R, |gamma| = 1 - r / R, negative if the
// tetrahedron's circumcentre is on the outer side of the face; removed by growing value, as the
// paper orders it. With two boundary faces the smaller gamma counts. Neither definition could be
// checked against its original text.
#include "sculpt/priority.h"

#include <algorithm>
#include <cmath>

#include "kernel/vec3.h"

namespace tetsculpt {
namespace {

using Vec = Vec3<double>;

Vec from(const Point3& a, const Point3& b) { return {b.x - a.x, b.y - a.y, b.z - a.z}; }

double length(const Vec& a) { return std::sqrt(dot(a, a)); }

/// A tetrahedron's corners in lexicographic order, with the facet opposite each.
struct SortedTet {
  std::array<const Point3*, 4> point;
  std::array<bool, 4> facet_on_boundary;
};

SortedTet sorted(const ManifoldSolid& solid, std::span<const Point3> points, TetId t,
                 const Exposure& exposure) {
  const auto& v = solid.vertices(t);
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return v[i] < v[j]; });
  SortedTet tet;
  for (std::size_t i = 0; i < 4; ++i) {
    tet.point[i] = &points[+v[order[i]]];
    tet.facet_on_boundary[i] = exposure.on_boundary(order[i]);
  }
  return tet;
}

/// The corners of facet i, in lexicographic order.
std::array<const Point3*, 3> facet(const SortedTet& tet, std::size_t i) {
  std::array<const Point3*, 3> corners;
  for (std::size_t j = 0, k = 0; j < 4; ++j) {
    if (j != i) corners[k++] = tet.point[j];
  }
  return corners;
}

double area(const std::array<const Point3*, 3>& c) {
  return length(cross(from(*c[0], *c[1]), from(*c[0], *c[2]))) / 2;
}

double circumradius(const std::array<const Point3*, 3>& c) {
  const double a = length(from(*c[0], *c[1]));
  const double b = length(from(*c[0], *c[2]));
  const double d = length(from(*c[1], *c[2]));
  return a * b * d / (4 * area(c));
}

/// The circumcentre, as seen from the first corner.
Vec circumcentre(const SortedTet& tet) {
  const Vec a = from(*tet.point[0], *tet.point[1]);
  const Vec b = from(*tet.point[0], *tet.point[2]);
  const Vec c = from(*tet.point[0], *tet.point[3]);
  const Vec sum = cross(b, c) * dot(a, a) + cross(c, a) * dot(b, b) + cross(a, b) * dot(c, c);
  return sum * (1 / (2 * dot(a, cross(b, c))));
}

}  // namespace

double Priority::key(TetId t, const Exposure& exposure) const {
  switch (criterion_) {
    case Criterion::kMinimalArea:
      return area_change(t, exposure);
    case Criterion::kGamma:
      return gamma(t, exposure);
    case Criterion::kLongestEdge:
    case Criterion::kConstrained:
      break;
  }
  return -static_cast<double>(solid_->longest_rank(t, exposure.facets));
}

double Priority::area_change(TetId t, const Exposure& exposure) const {
  const SortedTet tet = sorted(*solid_, points_, t, exposure);
  double change = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double a = area(facet(tet, i));
    change += tet.facet_on_boundary[i] ? -a : a;
  }
  return std::fabs(change);
}

double Priority::gamma(TetId t, const Exposure& exposure) const {
  const SortedTet tet = sorted(*solid_, points_, t, exposure);
  const Vec centre = circumcentre(tet);
  const double tet_radius = length(centre);
  double smallest = 2;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!tet.facet_on_boundary[i]) continue;
    const auto c = facet(tet, i);
    const double magnitude = 1 - circumradius(c) / tet_radius;
    // Inner and outer side of the facet: that of its opposite corner, and the other.
    const Vec normal = cross(from(*c[0], *c[1]), from(*c[0], *c[2]));
    const Vec offset = from(*tet.point[0], *c[0]);
    const double centre_side = dot(normal, centre) - dot(normal, offset);
    const double inner_side = dot(normal, from(*c[0], *tet.point[i]));
    smallest = std::min(smallest, centre_side * inner_side < 0 ? -magnitude : magnitude);
  }
  return smallest;
}

bool corners_less(const std::array<VertexId, 4>& a, const std::array<VertexId, 4>& b) {
  // The last two alone need not be in ascending order.
  const auto ascending = [](const std::array<VertexId, 4>& v) {
    return std::array{v[0], v[1], std::min(v[2], v[3]), std::max(v[2], v[3])};
  };
  return ascending(a) < ascending(b);
}

}  // namespace tetsculpt
