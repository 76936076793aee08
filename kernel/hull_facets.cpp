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

bool Facets::append(std::size_t count, std::vector<FacetIndex>& free) {
  constexpr std::size_t kBlock = 256;  // so that threads seldom wait for each other
  const std::lock_guard lock(growing_);
  const std::size_t begin = planes_.size();
  const std::size_t end = begin + std::max(count, kBlock);
  if (end > kNone / 4) throw std::length_error("more than 2^30 tetrahedra");
  if (shared_ &&
      end > std::min({planes_.capacity(), neighbors_.capacity(), farthest_.capacity()})) {
    return false;
  }
  planes_.resize(end);
  neighbors_.resize(end, {kNone, kNone, kNone, kNone});
  farthest_.resize(end, kNone);
  for (std::size_t f = end; f-- > begin;) free.push_back(static_cast<FacetIndex>(f));
  return true;
}

void Facets::set_hyperplane(FacetIndex f, const Spoke* a, const Spoke* b, const Spoke* c) {
  // A cyclic exchange keeps the orientation: bring the site at infinity last.
  if (!a) {
    a = b, b = c, c = nullptr;
  } else if (!b) {
    b = a, a = c, c = nullptr;
  }
  Hyperplane& n = planes_[f];
  const LiftedDifference& p = a->to;
  const LiftedDifference& q = b->to;
  const double xy = p.x * q.y - p.y * q.x;
  const double yz = p.y * q.z - p.z * q.y;
  const double zx = p.z * q.x - p.x * q.z;
  if (!c) {
    n.nx = -yz;
    n.ny = -zx;
    n.nz = -xy;
    n.nw = 0;
    n.error = 10 * kUnit * (a->length * b->length) / kNoExtent;
    n.extent = kNoExtent;
    return;
  }
  const LiftedDifference& r = c->to;
  const double xw = p.x * q.w - p.w * q.x;
  const double yw = p.y * q.w - p.w * q.y;
  const double zw = p.z * q.w - p.w * q.z;
  n.nx = -(yz * r.w - yw * r.z + zw * r.y);
  n.ny = -(zx * r.w - zw * r.x + xw * r.z);
  n.nz = -(xy * r.w - xw * r.y + yw * r.x);
  n.nw = xy * r.z + yz * r.x + zx * r.y;
  n.error = 22 * kUnit * (a->length * b->length * c->length) * reach_;
  const double sum = (a->length + b->length + c->length) * per_reach_;
  n.extent = std::max(static_cast<float>((1 + FLT_EPSILON) * sum), FLT_MIN);
}

void Facets::set_hyperplane(FacetIndex f) {
  std::array<Spoke, 4> spokes;
  std::array<const Spoke*, 4> to{};
  for (std::uint32_t i = 1; i < 4; ++i) {
    if (corners(f)[i] == kAtInfinity) continue;
    spokes[i] = spoke(sites_[corners(f)[i]], sites_[corners(f)[0]]);
    to[i] = &spokes[i];
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
