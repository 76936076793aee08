#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "kernel/large_array.h"
#include "kernel/large_block.h"
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

/// Bounds the errors of a facet's heights: two numbers, rounded up to the upper half of a float
/// each.
class ErrorFactors {
 public:
  ErrorFactors() = default;
  ErrorFactors(double square, double linear)
      : bits_(rounded_up(square) | rounded_up(linear) >> 16) {}
  /// Of heights that are linear: no square, which none else has.
  static ErrorFactors only_linear(double linear) {
    ErrorFactors result;
    result.bits_ = rounded_up(linear) >> 16;
    return result;
  }
  std::uint32_t bits() const { return bits_; }
  /// Per square of the distance; zero for linear heights only.
  double square() const { return static_cast<double>(std::bit_cast<float>(bits_ & 0xffff0000u)); }
  /// Per distance, where lengths are in units of the size of the set.
  double linear() const { return static_cast<double>(std::bit_cast<float>(bits_ << 16)); }
  bool is_linear() const { return bits_ <= 0xffffu; }

  // See hull_facets.cpp.
  static constexpr double kRoundings = 24 * 0x1p-53;
  static constexpr double kLinearRoundings = 12 * 0x1p-53;

 private:
  /// Always more than the value; what is too large for a float becomes infinite or no number.
  static std::uint32_t rounded_up(double value) {
    return (std::bit_cast<std::uint32_t>(static_cast<float>(value)) + 0x10000u) & 0xffff0000u;
  }
  std::uint32_t bits_;
};

/// A facet without its geometry.
struct FacetLinks {
  std::array<Site, 4> corners;
  std::array<Ridge, 4> neighbors;
  bool infinite() const { return corners[3] == kAtInfinity; }
  /// What is dead has no first corner; of those that are free see Inserter::mark_free.
  bool lives() const { return corners[0] != kNone; }
};

/// A facet with its lifted hyperplane through the first corner p, as the sphere around the corners:
/// the height of q = p + d above it is
///     nx dx + ny dy + nz dz - |d|^2,
/// the negative power of q (an infinite facet, which is a half-space: without |d|^2), positive if
/// the facet is visible from q. It is off by at most
///     square |d|^2 + linear (|dx| + |dy| + |dz|),   the latter in units of the size of the set.
/// All an insertion reads or writes of a facet is this: one cache line.
struct alignas(64) Facet {
  double nx, ny, nz;
  ErrorFactors error;
  std::uint32_t mark;  ///< scratch for the search that visits the facet
  FacetLinks links;
};
static_assert(sizeof(Facet) == 64);

///        0            Corners 0 to 2 are finite; 0 is the apex in a facet of a cone. Neighbour i
///       /|\           shares the ridge opposite corner i. The corners of a finite facet, in this
///      / | \          order, are a positively oriented tetrahedron (orient3d); an infinite facet's
///     1--|--3         orientation is the one by which shared ridges have opposite orientations in
///      \ | /          their two facets.
///        2
class Facets {
 public:
  /// `unit` is a power of two of which all coordinates are multiples.
  Facets(std::span<const Point3> sites, double unit);

  std::size_t size() const { return size_; }
  /// Appends at least so many facets, of which nothing is set, to a list: whoever has it sees to it
  /// that they don't seem to live. While shared, facets may not move in memory: false if they would
  /// have to.
  bool append(std::size_t count, std::vector<FacetIndex>& free);
  /// Leaves no facet here; gives away the memory of their hyperplanes. On up to `threads` threads,
  /// seen(thread, links) is called for each.
  template <class Seen>
  LargeBlock<FacetLinks> take_links(int threads, Seen&& seen) {
    return std::move(facets_).reduced_to(&Facet::links, std::exchange(size_, 0), threads, seen);
  }
  /// If the sites are on a small lattice, and many on the sphere through these four, remembers
  /// which, so that no test among them has to find that out.
  void remember_sphere(const std::array<Site, 4>& simplex);
  /// Whether it is on the sphere that is remembered, if one is.
  bool on_sphere(Site s) const { return !lattice_.empty() && (lattice_[s] & kOnSphere) != 0; }
  /// Between these, several threads may append.
  void share() { shared_ = true; }
  void unshare();

  const Facet& operator[](FacetIndex f) const { return facets_[f]; }
  std::array<Site, 4>& corners(FacetIndex f) { return facets_[f].links.corners; }
  const std::array<Site, 4>& corners(FacetIndex f) const { return facets_[f].links.corners; }
  std::array<Ridge, 4>& neighbors(FacetIndex f) { return facets_[f].links.neighbors; }
  const std::array<Ridge, 4>& neighbors(FacetIndex f) const { return facets_[f].links.neighbors; }
  std::uint32_t& mark(FacetIndex f) { return facets_[f].mark; }

  const Point3& point(Site s) const { return sites_[s]; }
  bool lives(FacetIndex f) const { return facets_[f].links.lives(); }
  void set_dead(FacetIndex f) { corners(f)[0] = kNone; }
  bool infinite(FacetIndex f) const { return facets_[f].links.infinite(); }

  /// Sets the hyperplane through the facet's first corner and three others, in their order; a null
  /// pointer, for the last only, stands for the site at infinity. This and the following remove the
  /// facet's mark.
  void set_hyperplane(FacetIndex f, const Spoke* a, const Spoke* b, const Spoke* c);
  /// Computes the differences, too.
  void set_hyperplane(FacetIndex f);
  void set_hyperplane(FacetIndex f, double nx, double ny, double nz, ErrorFactors error) {
    Facet& n = facets_[f];
    n.nx = nx;
    n.ny = ny;
    n.nz = nz;
    n.error = error;
    n.mark = 0;
  }
  /// From what a Facet begins with, as far as its mark, which must be 0: four doubles.
  void set_hyperplane(FacetIndex f, const void* row) {
    static_assert(offsetof(Facet, links) == 4 * sizeof(double));
    std::memcpy(static_cast<void*>(&facets_[f]), row, offsetof(Facet, links));
  }
  /// As large as the set, a power of two; and its inverse.
  double reach() const { return reach_; }
  double per_reach() const { return per_reach_; }

  /// The hyperplane's value at q, and by how much it may be wrong.
  struct Height {
    double value;
    double error;
  };
  Height height(FacetIndex f, const Point3& q) const;
  /// Whether q is on the visible side of f: exact, ties by kernel/perturbation.
  bool visible(FacetIndex f, Site q) const { return visible(f, q, height(f, sites_[q])); }
  bool visible(FacetIndex f, Site q, Height h) const {
    return h.value > h.error || (!(h.value < -h.error) && decide(f, q));
  }
  /// The same where the height is not clear.
  bool decide(FacetIndex f, Site q) const;

 private:
  bool finite_visible(FacetIndex f, Site q) const;
  bool coplanar_visible(FacetIndex f, Site q) const;
  bool tie_visible(FacetIndex f, Site q) const;

  std::span<const Point3> sites_;
  bool shared_ = false;
  bool full_ = false;  ///< some thread was told that there is no room
  std::mutex growing_;
  double reach_;                 ///< as large as the set, a power of two
  double per_reach_;             ///< 1 / reach_
  double per_unit_;              ///< 1 / unit
  double exact_below_;           ///< bound on an error of a finite facet below which there is none
  double exact_below_infinite_;  ///< the same for an infinite facet
  static constexpr std::uint64_t kOnSphere = std::uint64_t{1} << 63;
  /// Per site, if all coordinates are within 2^16 units: a number in lexicographic order, whose
  /// last three bits are zero; and kOnSphere.
  LargeArray<std::uint64_t> lattice_;
  std::size_t size_ = 0;
  LargeBlock<Facet> facets_;
};

/// |x| + |y| + |z|.
inline double l1_norm(const LiftedDifference& d) {
  return std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z);
}

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

inline Facets::Height Facets::height(FacetIndex f, const Point3& q) const {
  const Facet& n = facets_[f];
  const LiftedDifference d = lifted_difference(q, sites_[n.links.corners[0]]);
  const double w = n.error.is_linear() ? 0 : d.w;
  return {n.nx * d.x + n.ny * d.y + n.nz * d.z - w,
          n.error.square() * w + n.error.linear() * (l1_norm(d) * reach_)};
}

}  // namespace tetsculpt::hull
