// A facet's hyperplane is computed once, relative to its first corner p, so that a visibility test
// is three subtractions, a square and four multiply-adds instead of a 4 x 4 determinant.
//
// Error bound. Let A, B, C be the differences of the other corners from p and d that of the query,
// each with a fourth component |.|^2, and u = 2^-53. Roundings per path: differences 1, squares 5;
// a 2 x 2 minor of x, y, z 4, with the lift 8; a 3 x 3 minor without the lift 8, with it 12; times
// the query's component and summed 12 + 1 + 1 + 3 = 8 + 5 + 1 + 3 = 17. The permanents obey, by
// Cauchy-Schwarz,
//     P(y,z,w) <= |A| |B| |C| (|A| + |B| + |C|) =: pi sigma,    P(x,y,z) <= 1.16 pi,
// so the value is off by at most 17 u pi (sigma (|dx| + |dy| + |dz|) + 1.16 |d|^2) (1 + tiny); the
// constant 22 below, for both, covers the roundings of the bound itself. For an infinite facet C is
// (0, 0, 0, 1), the value is -(A x B).d, and 8 u |A| |B| (|dx| + |dy| + |dz|) is enough.
//
// All coordinates are multiples of a unit g. If the bound on the permanents is below 2^53 g^5,
// every intermediate result is a multiple of its power of g that fits in 53 bits: nothing was
// rounded, and the computed value is exact (for an infinite facet: 2^53 g^3). On integer grids this
// decides nearly all ties without expansions.
#include "kernel/hull_facets.h"

#include <algorithm>
#include <cassert>
#include <cfloat>
#include <cmath>
#include <stdexcept>

#include "kernel/perturbation.h"
#include "kernel/predicates.h"

namespace tetsculpt::hull {
namespace {

constexpr double kUnit = DBL_EPSILON / 2;
/// Extent of an infinite facet, so large that |d|^2 hardly counts.
constexpr float kNoExtent = 0x1p60f;

/// A power of two of about the size of the set.
double reach_of(std::span<const Point3> sites) {
  double reach = 0;
  for (const Point3& p : sites) {
    reach = std::max({reach, std::fabs(p.x - sites[0].x), std::fabs(p.y - sites[0].y),
                      std::fabs(p.z - sites[0].z)});
  }
  return reach > 0 ? std::ldexp(1.0, std::ilogb(reach)) : 1;
}

}  // namespace

Facets::Facets(std::span<const Point3> sites, double unit)
    : sites_(sites),
      reach_(reach_of(sites)),
      per_reach_(1 / reach_),
      exact_below_(16 * unit * unit * unit * unit * unit),
      exact_below_infinite_(8 * unit * unit * unit) {}

void Facets::reserve(std::size_t n) {
  planes_.reserve(n);
  neighbors_.reserve(n);
  farthest_.reserve(n);
}

FacetIndex Facets::append() {
  if (planes_.size() == kNone / 4) throw std::length_error("more than 2^30 tetrahedra");
  planes_.emplace_back();
  neighbors_.push_back({kNone, kNone, kNone, kNone});
  farthest_.push_back(kNone);
  return static_cast<FacetIndex>(planes_.size() - 1);
}

void Facets::set_hyperplane(FacetIndex f, const LiftedDifference* a, const LiftedDifference* b,
                            const LiftedDifference* c) {
  // A cyclic exchange keeps the orientation: bring the site at infinity last.
  if (!a) {
    a = b, b = c, c = nullptr;
  } else if (!b) {
    b = a, a = c, c = nullptr;
  }
  Hyperplane& n = planes_[f];
  const double xy = a->x * b->y - a->y * b->x;
  const double yz = a->y * b->z - a->z * b->y;
  const double zx = a->z * b->x - a->x * b->z;
  const double lengths_ab = std::sqrt(a->w * b->w);
  if (!c) {
    n.nx = -yz;
    n.ny = -zx;
    n.nz = -xy;
    n.nw = 0;
    n.error = 10 * kUnit * lengths_ab / kNoExtent;
    n.extent = kNoExtent;
    return;
  }
  const double xw = a->x * b->w - a->w * b->x;
  const double yw = a->y * b->w - a->w * b->y;
  const double zw = a->z * b->w - a->w * b->z;
  const double length_c = std::sqrt(c->w);
  const double product = lengths_ab * length_c;
  const double sum = std::sqrt(a->w) + std::sqrt(b->w) + length_c;
  n.nx = -(yz * c->w - yw * c->z + zw * c->y);
  n.ny = -(zx * c->w - zw * c->x + xw * c->z);
  n.nz = -(xy * c->w - xw * c->y + yw * c->x);
  n.nw = xy * c->z + yz * c->x + zx * c->y;
  n.error = 22 * kUnit * product * reach_;
  n.extent = std::max(static_cast<float>((1 + FLT_EPSILON) * sum * per_reach_), FLT_MIN);
}

void Facets::set_hyperplane(FacetIndex f) {
  std::array<LiftedDifference, 4> d;
  std::array<const LiftedDifference*, 4> to{};
  for (std::uint32_t i = 1; i < 4; ++i) {
    if (corners(f)[i] == kAtInfinity) continue;
    d[i] = difference(f, corners(f)[i]);
    to[i] = &d[i];
  }
  set_hyperplane(f, to[1], to[2], to[3]);
}

/// Where the hyperplane's value does not decide.
bool Facets::decide(FacetIndex f, Site q, Height h) const {
  const std::uint32_t infinite = infinite_corner(f);
  const bool exact = h.error < (infinite == 4 ? exact_below_ : exact_below_infinite_);
  if (exact && h.value != 0) return h.value > 0;
  const auto& c = corners(f);
  if (infinite == 4) {
    const auto inside = exact ? perturbed_inside : in_perturbed_sphere;
    return inside(sites_[c[0]], sites_[c[1]], sites_[c[2]], sites_[c[3]], sites_[q]);
  }
  if (!exact) {
    // The finite facet behind the hull triangle, with q in the place of its fourth corner.
    const Ridge behind = neighbors_[f][infinite];
    std::array<const Point3*, 4> p{};
    for (std::uint32_t i = 0; i < 4; ++i) {
      p[i] = &sites_[i == corner_of(behind) ? q : corners(facet_of(behind))[i]];
    }
    const Sign side = orient3d(*p[0], *p[1], *p[2], *p[3]);
    if (side != Sign::kZero) return side == Sign::kNegative;
  }
  return coplanar_visible(f, q);
}

/// A point in the plane of a hull triangle sees the infinite facet there iff it sees the finite
/// one.
bool Facets::coplanar_visible(FacetIndex f, Site q) const {
  const auto& c = corners(facet_of(neighbors_[f][infinite_corner(f)]));
  return in_perturbed_sphere(sites_[c[0]], sites_[c[1]], sites_[c[2]], sites_[c[3]], sites_[q]);
}

}  // namespace tetsculpt::hull
