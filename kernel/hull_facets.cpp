// A facet's hyperplane is computed once, relative to its first corner p, divided by its last
// component and moved to the middle of the set, so that a visibility test is three multiply-adds of
// one row of four numbers, which needs no point but the query, against a constant.
//
// Error bound. Let A, B, C be the differences of the other corners from p and d that of the query,
// each with a fourth component |.|^2, N the hyperplane through them, R the radius, beyond which
// there is no site, and u = 2^-53. Roundings per path of N.d: differences 1, squares 5; a 2 x 2
// minor of x, y, z 4, with the lift 8; a 3 x 3 minor without the lift 8, with it 12; times the
// query's component and summed 12 + 1 + 1 + 3 = 8 + 5 + 1 + 3 = 17. The permanents obey, by
// Cauchy-Schwarz,
//     P(y,z,w) <= |A| |B| |C| (|A| + |B| + |C|) =: pi sigma,    P(x,y,z) <= 1.16 pi.
// Divided by -Nw as it was computed, which takes two roundings more of the other components, n.d -
// |d|^2 is off by at most
//     19 u (pi / -Nw) (sigma (|dx| + |dy| + |dz|) + 1.16 |d|^2) (1 + tiny).
// With |d| <= 2 R and sigma <= 6 R that is 484 u R^2 pi / -Nw. It is also, where |d| is at most
// twice the sphere's diameter |n|, and sigma <= 3 |n|, 286 u |n|^2 pi / -Nw; farther off the height
// is below -|d|^2 / 2, and its sign is right if 500 u pi / -Nw < 1, which makes the computed |n|
// good to a seventh, too. So the bound is 500 u min(|n|^2, R^2) pi / -Nw, or more than any height
// where that ratio is too large or Nw has the wrong sign or none. (pi comes from squares: their
// product of degree 6 is exact where it is subnormal, see kernel/distinct_points; an infinite
// facet's may then be off by a sixth, of which it has ten times to spare.)
//     For an infinite facet C is (0, 0, 0, R^2) and n, of the length 2^60 R |A x B| / (|A| |B|), is
// off by 10 u 2^60 R: n.d by 36 2^60 u R^2, to which neither w nor p's lift, below R^2, add much.
//     By four, kernel/hull_cone_lanes multiplies and adds in one: no path has more roundings.
//     Moved to the middle, n becomes n + 2 p and the offset |p|^2 - (n + 2 p).p: some 20 roundings
// of |n| R + R^2, and 2^-40 of the offset, which is no more than that, for the bits that hold the
// exponent. 2^-39 (R (|nx| + |ny| + |nz|) + 4 R^2) is enough for all. A sample must be 10^5 times
// finer somewhere than it is large for such a bound to leave tests open; those come to a second
// one, of N.d itself with its own |d|. (65,536 points whose scales span nine decades take a sixth
// longer than with a bound of |d| in the first stage; a million of a torus, with 13 million tests
// open, a twentieth less.)
//
// All coordinates are multiples of a unit g. Where the value does not decide, N.d is computed again
// without the division: if the bound on the permanents is below 2^53 g^5, every intermediate result
// is a multiple of its power of g that fits in 53 bits: nothing was rounded, and the value is exact
// (for an infinite facet: 2^53 g^3). On integer grids this decides nearly all ties without
// expansions. Where coordinates are within 2^16 units, nothing that orient3d computes is rounded,
// and one number per site holds its lexicographic order, so that a tie takes one determinant and no
// branch on which point is dominant. Where in addition many points are on one sphere, that of the
// first simplex, ties among them need no test: together with walks over the hull a third off the
// hull of a lattice sphere; a fifth off that of a grid.
#include "kernel/hull_facets.h"

#include <algorithm>
#include <cassert>
#include <cfloat>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "kernel/box.h"
#include "kernel/perturbation.h"
#include "kernel/predicates.h"

namespace tetsculpt::hull {
namespace {

constexpr double kUnit = DBL_EPSILON / 2;
/// Twice as many as samples of a surface or a volume have: what is not used is only an address.
constexpr std::size_t kExpectedPerSite = 16;
/// Facets are appended up to the end of a large page: two threads that use one for the first time
/// at once would both clear it.
constexpr std::size_t kPerPage = kLargePageBytes / sizeof(Facet);
constexpr std::size_t kFirstInPage = kLargeArrayOffset / sizeof(Facet);  // the first facet's place
static_assert(kFirstInPage * sizeof(Facet) == kLargeArrayOffset);

/// |x| + |y| + |z|.
double l1_norm(const LiftedDifference& d) {
  return std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z);
}

Point3 middle_of(const Box& box) {
  const auto middle = [](double low, double high) { return low + (high - low) / 2; };
  return {middle(box.low.x, box.high.x), middle(box.low.y, box.high.y),
          middle(box.low.z, box.high.z)};
}

/// From the middle to a corner of the box, a little more. The middle is rounded.
double radius_of(const Box& box, const Point3& middle) {
  const auto reach = [](double low, double high, double m) { return std::max(high - m, m - low); };
  const double x = reach(box.low.x, box.high.x, middle.x);
  const double y = reach(box.low.y, box.high.y, middle.y);
  const double z = reach(box.low.z, box.high.z, middle.z);
  return std::sqrt(x * x + y * y + z * z) * (1 + 0x1p-30);
}

/// A hyperplane through the first corner, not divided.
struct Normal {
  double x, y, z, w;
};

Normal normal(const LiftedDifference& p, const LiftedDifference& q, const LiftedDifference& r) {
  const double xy = p.x * q.y - p.y * q.x;
  const double yz = p.y * q.z - p.z * q.y;
  const double zx = p.z * q.x - p.x * q.z;
  const double xw = p.x * q.w - p.w * q.x;
  const double yw = p.y * q.w - p.w * q.y;
  const double zw = p.z * q.w - p.w * q.z;
  return {-(yz * r.w - yw * r.z + zw * r.y), -(zx * r.w - zw * r.x + xw * r.z),
          -(xy * r.w - xw * r.y + yw * r.x), xy * r.z + yz * r.x + zx * r.y};
}

/// The same where the third difference is that of the site at infinity.
Normal half_space(const LiftedDifference& p, const LiftedDifference& q) {
  return {p.z * q.y - p.y * q.z, p.x * q.z - p.z * q.x, p.y * q.x - p.x * q.y, 0};
}

double value(const Normal& n, const LiftedDifference& d) {
  return n.x * d.x + n.y * d.y + n.z * d.z + n.w * d.w;
}

/// Whether they are in one coordinate plane.
bool share_coordinate(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const auto equal = [](double p, double q, double r, double s) {
    return p == q && p == r && p == s;
  };
  return equal(a.x, b.x, c.x, d.x) || equal(a.y, b.y, c.y, d.y) || equal(a.z, b.z, c.z, d.z);
}

/// See Facets::lattice_.
LargeArray<std::uint64_t> lattice_numbers(std::span<const Point3> sites, const Box& box,
                                          double per_unit) {
  constexpr int kBits = 16;
  LargeArray<std::uint64_t> numbers;
  if (!(box.longest_side() * per_unit < 1 << kBits)) return numbers;
  const Point3& low = box.low;
  const auto units = [&](double difference) {
    return static_cast<std::uint64_t>(difference * per_unit);
  };
  numbers.reserve(sites.size());
  for (const Point3& p : sites) {
    const std::uint64_t xy = units(p.x - low.x) << kBits | units(p.y - low.y);
    numbers.push_back((xy << kBits | units(p.z - low.z)) << 3);
  }
  return numbers;
}

}  // namespace

Facets::Facets(std::span<const Point3> sites, double unit, int threads)
    : Facets(sites, unit, box_of(sites, threads)) {}

Facets::Facets(std::span<const Point3> sites, double unit, const Box& box)
    : sites_(sites),
      middle_(middle_of(box)),
      radius_(radius_of(box, middle_)),
      error_terms_{radius_ * radius_, 0x1p-39 * radius_, 0x1p-37 * radius_ * radius_},
      per_unit_(1 / unit),
      exact_below_(16 * unit * unit * unit * unit * unit),
      exact_below_infinite_(8 * unit * unit * unit),
      lattice_(lattice_numbers(sites, box, per_unit_)),
      facets_(kExpectedPerSite * sites.size() + kExpectedPerSite),
      marks_(facets_.capacity()) {}

FacetRoom Facets::append(std::size_t count) {
  const std::lock_guard lock(growing_);
  const std::size_t begin = size_;
  const std::size_t least = begin + count;
  if (least > kMost) throw std::length_error("more than 2^30 tetrahedra");
  if (least > facets_.capacity()) {
    full_ = shared_;
    if (shared_) return {};
    grow(std::max(least, 3 * facets_.capacity() / 2));
  }
  const std::size_t page_end = ((least + kFirstInPage) / kPerPage + 1) * kPerPage - kFirstInPage;
  const std::size_t end = std::min({page_end, facets_.capacity(), kMost});
  size_ = end;
  for (std::size_t f = begin; f < end; ++f) marks_[f] = Mark::kUnmet;
  return {static_cast<FacetIndex>(begin), static_cast<FacetIndex>(end)};
}

void Facets::give_back(std::vector<FacetRoom> rooms) {
  std::ranges::sort(rooms, std::ranges::greater{}, &FacetRoom::end);
  for (const FacetRoom& room : rooms) {
    if (room.end == size_) size_ = room.begin;
    for (FacetIndex f = room.begin; f < room.end && f < size_; ++f) set_dead(f);
  }
}

void Facets::unshare() {
  shared_ = false;
  if (full_) grow(3 * facets_.capacity() / 2);
  full_ = false;
}

void Facets::reserve(std::size_t count) {
  if (count > facets_.capacity()) grow(count);
}

void Facets::grow(std::size_t capacity) {
  facets_.grow(size_, capacity);
  marks_.grow(size_, capacity);
}

void Facets::remember_sphere(const std::array<Site, 4>& simplex) {
  constexpr std::size_t kSample = 64;
  constexpr std::size_t kMany = 16;  // of them
  if (lattice_.size() < kSample) return;
  const auto on_sphere = [&](std::size_t s) {
    return insphere(sites_[simplex[0]], sites_[simplex[1]], sites_[simplex[2]], sites_[simplex[3]],
                    sites_[s]) == Sign::kZero;
  };
  std::size_t found = 0;
  for (std::size_t k = 0; k < kSample; ++k) found += on_sphere(sites_.size() * k / kSample);
  if (found < kMany) return;
  for (std::size_t s = 0; s < sites_.size(); ++s) {
    if (on_sphere(s)) lattice_[s] |= kOnSphere;
  }
}

void Facets::set_hyperplane(FacetIndex f, const LiftedDifference& apex, const Spoke& a,
                            const Spoke& b, const Spoke& c) {
  const Normal m = normal(a, b, c);
  const double size = std::sqrt(a.w * b.w * c.w);
  double scale = infinite(f) ? kInfiniteNormal / size : -1 / m.w;
  const double growth = ErrorTerms::kGrowth * (scale * size);
  const bool useful = infinite(f) || (m.w < 0 && growth < 1);
  if (!useful) scale = 0;
  double nx = scale * m.x;
  double ny = scale * m.y;
  double nz = scale * m.z;
  double square = error_terms_.square;
  if (!infinite(f)) square = std::min(nx * nx + ny * ny + nz * nz, square);
  nx += 2 * apex.x;
  ny += 2 * apex.y;
  nz += 2 * apex.z;
  const double offset = apex.w - (nx * apex.x + ny * apex.y + nz * apex.z);
  const double error = (useful ? growth * square : ErrorTerms::kUseless) +
                       (error_terms_.linear * l1_norm({nx, ny, nz, 0}) + error_terms_.constant);
  // The next power of two.
  const std::uint64_t exponent = (std::bit_cast<std::uint64_t>(error) >> 52) + 1;
  const std::uint64_t bits =
      (std::bit_cast<std::uint64_t>(offset) & ~std::uint64_t{0xfff}) | exponent;
  const std::array<double, 4> row{nx, ny, nz, std::bit_cast<double>(bits)};
  set_hyperplane(f, row.data());
}

void Facets::set_hyperplane(FacetIndex f) {
  const auto& c = corners(f);
  const auto spoke = [&](std::uint32_t i) {
    return c[i] == kAtInfinity ? spoke_to_infinity()
                               : lifted_difference(sites_[c[i]], sites_[c[0]]);
  };
  set_hyperplane(f, lifted(sites_[c[0]]), spoke(1), spoke(2), spoke(3));
}

/// Where the hyperplane's value does not decide.
bool Facets::decide(FacetIndex f, Site q) const {
  if (!infinite(f)) return finite_visible(f, q);
  const auto& c = corners(f);
  if (share_coordinate(sites_[c[0]], sites_[c[1]], sites_[c[2]], sites_[q])) {
    return coplanar_visible(f, q);
  }
  const LiftedDifference p = lifted_difference(sites_[c[1]], sites_[c[0]]);
  const LiftedDifference r = lifted_difference(sites_[c[2]], sites_[c[0]]);
  const LiftedDifference d = lifted_difference(sites_[q], sites_[c[0]]);
  if (10 * kUnit * l1_norm(p) * l1_norm(r) * l1_norm(d) < exact_below_infinite_) {
    const double height = value(half_space(p, r), d);
    return height != 0 ? height > 0 : coplanar_visible(f, q);
  }
  // The finite facet behind the hull triangle, with q in the place of its fourth corner.
  const Ridge behind = neighbors(f)[3];
  std::array<const Point3*, 4> t{};
  for (std::uint32_t i = 0; i < 4; ++i) {
    t[i] = &sites_[i == corner_of(behind) ? q : corners(facet_of(behind))[i]];
  }
  const Sign side = orient3d(*t[0], *t[1], *t[2], *t[3]);
  return side != Sign::kZero ? side == Sign::kNegative : coplanar_visible(f, q);
}

bool Facets::finite_visible(FacetIndex f, Site q) const {
  const auto& c = corners(f);
  const auto judged_by = [&](auto&& judge) {
    return judge(sites_[c[0]], sites_[c[1]], sites_[c[2]], sites_[c[3]], sites_[q]);
  };
  if (!lattice_.empty()) {
    const std::uint64_t all =
        lattice_[c[0]] & lattice_[c[1]] & lattice_[c[2]] & lattice_[c[3]] & lattice_[q];
    if ((all & kOnSphere) != 0) return tie_visible(f, q);
  }
  const Point3& origin = sites_[c[0]];
  const std::array<LiftedDifference, 4> d = {
      lifted_difference(sites_[c[1]], origin), lifted_difference(sites_[c[2]], origin),
      lifted_difference(sites_[c[3]], origin), lifted_difference(sites_[q], origin)};
  const double pi = std::sqrt(d[0].w * d[1].w * d[2].w);
  const double sigma = std::sqrt(d[0].w) + std::sqrt(d[1].w) + std::sqrt(d[2].w);
  const double error = 22 * kUnit * pi * (sigma * l1_norm(d[3]) + 1.16 * d[3].w);
  const double height = value(normal(d[0], d[1], d[2]), d[3]);
  if (std::fabs(height) > error) return height > 0;
  if (error < exact_below_) return height != 0 ? height > 0 : tie_visible(f, q);
  const std::optional<Sign> side =
      judged_by([&](const auto&... points) { return insphere_in_units(points..., per_unit_); });
  if (!side) return judged_by(in_perturbed_sphere);
  return *side != Sign::kZero ? *side == Sign::kPositive : tie_visible(f, q);
}

/// Whether q, which is on the sphere of a finite facet, sees it: the rule of perturbed_inside.
bool Facets::tie_visible(FacetIndex f, Site q) const {
  const auto& c = corners(f);
  if (lattice_.empty()) {
    return perturbed_inside(sites_[c[0]], sites_[c[1]], sites_[c[2]], sites_[c[3]], sites_[q]);
  }
  const auto number = [&](Site s, std::uint64_t place) {
    return (lattice_[s] & ~kOnSphere) | place;
  };
  std::array<std::uint64_t, 5> left{number(c[0], 0), number(c[1], 1), number(c[2], 2),
                                    number(c[3], 3), number(q, 4)};
  for (;;) {
    const std::size_t dominant = std::ranges::max(left) & 7;
    if (dominant == 4) return false;
    // The others, in an order in which this corner is above their plane.
    static constexpr std::uint8_t kOthers[4][3] = {{2, 1, 3}, {2, 3, 0}, {0, 3, 1}, {0, 1, 2}};
    const auto& others = kOthers[dominant];
    const Point3& origin = sites_[c[others[0]]];
    const Normal plane = half_space(lifted_difference(sites_[c[others[1]]], origin),
                                    lifted_difference(sites_[c[others[2]]], origin));
    const double height = value(plane, lifted_difference(sites_[q], origin));
    if (height != 0) return height > 0;
    left[dominant] = 0;
  }
}

/// A point in the plane of a hull triangle sees the infinite facet there iff it sees the finite
/// one.
bool Facets::coplanar_visible(FacetIndex f, Site q) const {
  return visible(facet_of(neighbors(f)[3]), q);
}

}  // namespace tetsculpt::hull
