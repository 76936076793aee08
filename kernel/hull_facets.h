#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

#include "kernel/large_array.h"
#include "kernel/point.h"

/// The store of the lifted hull while it grows: facets with their neighbours, hyperplanes and
/// conflict sets. Internal to kernel/lifted_hull.
namespace tetsculpt::hull {

/// A site is a vertex id, bare; a facet's index is stable while it lives.
using Site = std::uint32_t;
using FacetIndex = std::uint32_t;
inline constexpr std::uint32_t kNone = 0xffffffffu;
/// The site at infinity in the direction of the lift.
inline constexpr Site kAtInfinity = kNone;

/// One ridge seen from one facet: 4 * facet + the corner opposite the ridge.
using Ridge = std::uint32_t;
constexpr Ridge ridge(FacetIndex f, std::uint32_t corner) { return 4 * f + corner; }
constexpr FacetIndex facet_of(Ridge r) { return r >> 2; }
constexpr std::uint32_t corner_of(Ridge r) { return r & 3; }

/// The difference q - p of two sites and its lift |q - p|^2.
struct LiftedDifference {
  double x;
  double y;
  double z;
  double w;
};

/// From a cone's apex to one of its other corners.
struct Spoke {
  LiftedDifference to;
  double length;
};

/// A facet's lifted hyperplane through its first corner p. The value of
///     nx dx + ny dy + nz dz + nw |d|^2,  d = q - p,
/// is positive if the facet is visible from q, and off by at most
///     error (extent (|dx| + |dy| + |dz|) + |d|^2 / reach),
/// with the reach of the whole set, a power of two.
/// A visibility test needs no more than this and p: one cache line.
struct alignas(64) Hyperplane {
  double nx, ny, nz, nw;
  double error;
  float extent;
  std::uint32_t mark = 0;  ///< scratch for the search that visits the facet
  std::array<Site, 4> corners{kNone, kNone, kNone, kNone};
};
static_assert(sizeof(Hyperplane) == 64);

///        0            Corner 0 is finite: in a facet of a cone, the cone's apex. Neighbour i
///        shares the
///       /|\           ridge opposite corner i. The corners of a finite facet, in this order, are a
///      / | \          positively oriented tetrahedron (orient3d); an infinite facet's orientation
///      is
///     1--|--3         the one by which shared ridges have opposite orientations in their two
///     facets.
///      \ | /
///        2
class Facets {
 public:
  /// `unit` is a power of two of which all coordinates are multiples.
  Facets(std::span<const Point3> sites, double unit);

  std::size_t size() const { return planes_.size(); }
  void reserve(std::size_t n);
  /// Appends an unlinked facet without a hyperplane.
  FacetIndex append();
  /// Appends at least so many to a list. While shared, facets may not move in memory: false if they
  /// would have to.
  bool append(std::size_t count, std::vector<FacetIndex>& free);
  /// Between these, several threads may append.
  void share() { shared_ = true; }
  void unshare() { shared_ = false; }

  /// Gives the memory of corners and hyperplanes away; only neighbours are left.
  void release_hyperplanes() { planes_ = LargeArray<Hyperplane>(); }

  std::array<Site, 4>& corners(FacetIndex f) { return planes_[f].corners; }
  const std::array<Site, 4>& corners(FacetIndex f) const { return planes_[f].corners; }
  std::array<Ridge, 4>& neighbors(FacetIndex f) { return neighbors_[f]; }
  const std::array<Ridge, 4>& neighbors(FacetIndex f) const { return neighbors_[f]; }
  /// First site of the facet's conflict set, the farthest, or kNone.
  Site& farthest(FacetIndex f) { return farthest_[f]; }
  std::uint32_t& mark(FacetIndex f) { return planes_[f].mark; }

  const Point3& point(Site s) const { return sites_[s]; }
  /// The corner at infinity, or 4 if the facet is finite.
  std::uint32_t infinite_corner(FacetIndex f) const;

  /// Sets the hyperplane through the facet's first corner and three others, in their order; a null
  /// pointer stands for the site at infinity.
  void set_hyperplane(FacetIndex f, const Spoke* a, const Spoke* b, const Spoke* c);
  /// Computes the differences, too.
  void set_hyperplane(FacetIndex f);

  /// Starts to fetch what a visibility test and what follows it will read.
  void prefetch(FacetIndex f) const {
    __builtin_prefetch(&planes_[f]);
    __builtin_prefetch(&neighbors_[f]);
  }

  LiftedDifference difference(FacetIndex f, Site q) const;
  /// The hyperplane's value at q, and by how much it may be wrong.
  struct Height {
    double value;
    double error;
  };
  Height height(FacetIndex f, Site q) const;
  /// Power of q with respect to a finite facet's sphere, up to rounding. Only for choosing a way.
  double power(FacetIndex f, Height h) const { return h.value / planes_[f].nw; }
  /// Whether q is on the visible side of f: exact, ties by kernel/perturbation.
  bool visible(FacetIndex f, Site q) const { return visible(f, q, height(f, q)); }
  bool visible(FacetIndex f, Site q, Height h) const {
    return h.value > h.error || (h.value >= -h.error && decide(f, q, h));
  }

 private:
  bool decide(FacetIndex f, Site q, Height h) const;
  bool coplanar_visible(FacetIndex f, Site q) const;

  std::span<const Point3> sites_;
  bool shared_ = false;
  std::mutex growing_;
  double reach_;                 ///< as large as the set, a power of two
  double per_reach_;             ///< 1 / reach_
  double exact_below_;           ///< error of a finite facet's height below which it has none
  double exact_below_infinite_;  ///< the same for an infinite facet
  LargeArray<Hyperplane> planes_;
  LargeArray<std::array<Ridge, 4>> neighbors_;
  LargeArray<Site> farthest_;
};

inline LiftedDifference lifted_difference(const Point3& q, const Point3& p) {
  const double x = q.x - p.x;
  const double y = q.y - p.y;
  const double z = q.z - p.z;
  return {x, y, z, x * x + y * y + z * z};
}

inline Spoke spoke(const Point3& q, const Point3& p) {
  const LiftedDifference d = lifted_difference(q, p);
  return {d, std::sqrt(d.w)};
}

inline std::uint32_t Facets::infinite_corner(FacetIndex f) const {
  const auto& c = planes_[f].corners;
  return c[1] == kAtInfinity ? 1 : c[2] == kAtInfinity ? 2 : c[3] == kAtInfinity ? 3 : 4;
}

inline LiftedDifference Facets::difference(FacetIndex f, Site q) const {
  return lifted_difference(sites_[q], sites_[planes_[f].corners[0]]);
}

inline Facets::Height Facets::height(FacetIndex f, Site q) const {
  const LiftedDifference d = difference(f, q);
  const Hyperplane& n = planes_[f];
  const double along = std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z);
  return {n.nx * d.x + n.ny * d.y + n.nz * d.z + n.nw * d.w,
          n.error * (static_cast<double>(n.extent) * along + d.w * per_reach_)};
}

}  // namespace tetsculpt::hull
