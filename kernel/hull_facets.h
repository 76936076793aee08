#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "kernel/box.h"
#include "kernel/large_array.h"
#include "kernel/large_block.h"
#include "kernel/point.h"

/// The store of the lifted hull while it grows: facets with their neighbours, hyperplanes and
/// marks. Internal to kernel/lifted_hull.
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
using Spoke = LiftedDifference;

/// Facets that were never used: [begin, end).
struct FacetRoom {
  FacetIndex begin = 0;
  FacetIndex end = 0;
  std::size_t size() const { return end - begin; }
};

/// What an insertion under way finds a listed facet to be at first sight; what is unclear may be
/// decided later. Of a type that aliases no other.
enum class Mark : std::uint8_t { kUnmet = 0, kVisible = 1, kUnclear = 16 };

/// A facet without its geometry.
struct FacetLinks {
  std::array<Site, 4> corners;
  std::array<Ridge, 4> neighbors;
  bool infinite() const { return corners[3] == kAtInfinity; }
  /// What is dead has no first corner; of those that are free see Inserter::mark_free.
  bool lives() const { return corners[0] != kNone; }
};

/// A facet with its lifted hyperplane: the height above it of q, as lifted from the middle of the
/// set, is
///     nx x + ny y + nz z + offset - w,
/// the negative power of q, positive if the facet is visible from q. An infinite facet is taken for
/// a sphere so large that w does not matter. All an insertion reads or writes of a facet but its
/// mark is this: one cache line.
struct alignas(64) Facet {
  double nx, ny, nz;
  double offset;  ///< its last twelve bits are the exponent of error()
  FacetLinks links;

  /// A site's height has the right sign if it is more than this: a power of two.
  double error() const { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(offset) << 52); }
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
  /// `unit` is a power of two of which all coordinates are multiples, or 0 if none is of use.
  Facets(std::span<const Point3> sites, double unit, int threads = 1);

  static constexpr std::size_t kMost = kNone / 4;  ///< ridges are numbered, too
  std::size_t size() const { return size_; }
  /// At least so many new facets, of which nothing is set. While shared, facets may not move in
  /// memory: none if they would have to.
  FacetRoom append(std::size_t count);
  /// Must come after append(), and may come while others append.
  void touch(const FacetRoom& appended) { facets_.touch(appended.begin, appended.end); }
  /// Makes room for so many in all; not while shared.
  void reserve(std::size_t count);
  /// Takes back what was appended and never used.
  void give_back(std::vector<FacetRoom> rooms);
  /// Leaves no facet here; gives away the memory of their hyperplanes. See LargeBlock::reduced_to.
  template <class Seen>
  LargeBlock<FacetLinks> take_links(int threads, Seen&& seen) {
    marks_ = LargeBlock<Mark>();  // for `= {}` in a template, clang 14 makes no destructor
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
  /// Whether some thread was told, since share(), that there is no room.
  bool full() const { return full_.load(std::memory_order_relaxed); }

  const Facet& operator[](FacetIndex f) const { return facets_[f]; }
  std::array<Site, 4>& corners(FacetIndex f) { return facets_[f].links.corners; }
  const std::array<Site, 4>& corners(FacetIndex f) const { return facets_[f].links.corners; }
  std::array<Ridge, 4>& neighbors(FacetIndex f) { return facets_[f].links.neighbors; }
  const std::array<Ridge, 4>& neighbors(FacetIndex f) const { return facets_[f].links.neighbors; }
  /// Asks for what an insertion will read and write.
  void prefetch(FacetIndex f) const { __builtin_prefetch(&facets_[f], 1); }
  /// None between insertions.
  Mark& mark(FacetIndex f) { return marks_[f]; }

  const Point3& point(Site s) const { return sites_[s]; }
  bool lives(FacetIndex f) const { return facets_[f].links.lives(); }
  void set_dead(FacetIndex f) { corners(f)[0] = kNone; }
  bool infinite(FacetIndex f) const { return facets_[f].links.infinite(); }

  /// A site's difference from the middle of the set.
  LiftedDifference lifted(const Point3& q) const;
  /// Sets the hyperplane through the facet's first corner, lifted, and three others, in their
  /// order, as seen from there.
  void set_hyperplane(FacetIndex f, const LiftedDifference& apex, const Spoke& a, const Spoke& b,
                      const Spoke& c);
  /// Computes the differences, too.
  void set_hyperplane(FacetIndex f);
  /// From what a Facet begins with: four doubles.
  void set_hyperplane(FacetIndex f, const void* row) {
    static_assert(offsetof(Facet, links) == 4 * sizeof(double));
    std::memcpy(static_cast<void*>(&facets_[f]), row, offsetof(Facet, links));
  }
  /// From anywhere to the site at infinity.
  Spoke spoke_to_infinity() const { return {0, 0, 0, radius_ * radius_}; }
  /// So many times the radius is about the length of an infinite facet's normal.
  static constexpr double kInfiniteNormal = 0x1p60;
  /// What a height's error is made of, see hull_facets.cpp.
  struct ErrorTerms {
    double square;    ///< at most this, instead of nx^2 + ny^2 + nz^2
    double linear;    ///< times |nx| + |ny| + |nz|
    double constant;  ///< a term of its own
    static constexpr double kGrowth = 500 * 0x1p-53;  ///< times |A| |B| |C| / -Nw
    static constexpr double kUseless = 0x1p500;       ///< more than any height
  };
  const ErrorTerms& error_terms() const { return error_terms_; }

  /// The hyperplane's value at q, and the error() of it.
  struct Height {
    double value;
    double error;
  };
  Height height(FacetIndex f, const LiftedDifference& q) const;
  /// Whether q is on the visible side of f: exact, ties by kernel/perturbation.
  bool visible(FacetIndex f, Site q) const {
    const Height h = height(f, lifted(sites_[q]));
    return h.value > h.error || (!(h.value < -h.error) && decide(f, q));
  }
  /// The same where the height is not clear.
  bool decide(FacetIndex f, Site q) const;

 private:
  Facets(std::span<const Point3> sites, double unit, const Box& box);
  void grow(std::size_t capacity);
  bool finite_visible(FacetIndex f, Site q) const;
  bool coplanar_visible(FacetIndex f, Site q) const;
  bool tie_visible(FacetIndex f, Site q) const;

  std::span<const Point3> sites_;
  Point3 middle_;
  double radius_;  ///< no site is farther from the middle
  ErrorTerms error_terms_;
  double per_unit_;              ///< 1 / unit
  double exact_below_;           ///< bound on an error of a finite facet below which there is none
  double exact_below_infinite_;  ///< the same for an infinite facet
  static constexpr std::uint64_t kOnSphere = std::uint64_t{1} << 63;
  /// Per site, if all coordinates are within 2^16 units: a number in lexicographic order, whose
  /// last three bits are zero; and kOnSphere.
  LargeArray<std::uint64_t> lattice_;
  LargeBlock<Facet> facets_;
  LargeBlock<Mark> marks_;
  // What follows changes, while other threads read what is above: not in one cache line.
  alignas(64) std::mutex growing_;
  std::size_t size_ = 0;
  bool shared_ = false;
  std::atomic<bool> full_ = false;
};

inline LiftedDifference lifted_difference(const Point3& q, const Point3& p) {
  const double x = q.x - p.x;
  const double y = q.y - p.y;
  const double z = q.z - p.z;
  return {x, y, z, x * x + y * y + z * z};
}

inline LiftedDifference Facets::lifted(const Point3& q) const {
  return lifted_difference(q, middle_);
}

inline Facets::Height Facets::height(FacetIndex f, const LiftedDifference& q) const {
  const Facet& n = facets_[f];
  return {n.nx * q.x + n.ny * q.y + n.nz * q.z + (n.offset - q.w), n.error()};
}

}  // namespace tetsculpt::hull
