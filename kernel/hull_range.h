#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "kernel/hull_facets.h"
#include "kernel/hull_sites.h"

/// Which facets are whose. Internal to kernel/lifted_hull.
namespace tetsculpt::hull {

/// A point's coordinates, or where it is along three diagonals of space.
using Position = std::array<double, 3>;

/// Three of the four diagonals of space: what y and z are multiplied with before they are added to
/// x, by one at a time and by four alike.
using Diagonals = std::array<std::array<double, 2>, 3>;

/// Those of a turn. The first ones of an even turn and of the next are each other's mirror images
/// across an axis; after four turns they come again.
inline Diagonals diagonals(std::size_t axis, std::size_t turn) {
  constexpr std::array<std::array<std::array<double, 2>, 4>, 3> kInOrder{
      {{{{1, 1}, {-1, -1}, {1, -1}, {-1, 1}}},    // x
       {{{1, 1}, {-1, 1}, {1, -1}, {-1, -1}}},    // y
       {{{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}}}};  // z
  const auto& all = kInOrder[axis];
  return {all[turn % 4], all[(turn + 1) % 4], all[(turn + 2) % 4]};
}

/// A part of space, by where facets' spheres have their centers: a box along three diagonals. Each
/// facet is in one of several that share out space, or in none.
class CenterBox {
 public:
  static constexpr std::size_t kAxes = 3;

  /// From a low corner on and below a high one, see place().
  CenterBox(const Diagonals& diagonals, const Position& low, const Position& high)
      : diagonals_(diagonals), low_(low), high_(high) {}

  /// Where a point is that comes as its difference from the middle of the set.
  static Position place(const Diagonals& diagonals, const LiftedDifference& q) {
    return along(diagonals, 2 * q.x, 2 * q.y, 2 * q.z);
  }
  /// A facet's normal is twice its center, or beyond all points if it is infinite.
  bool contains(const Facet& f) const {
    const Position at = along(diagonals_, f.nx, f.ny, f.nz);
    bool inside = true;
    for (std::size_t i = 0; i < kAxes; ++i) inside &= low_[i] <= at[i] && at[i] < high_[i];
    return inside;
  }
  double low(std::size_t axis) const { return low_[axis]; }
  double high(std::size_t axis) const { return high_[axis]; }
  const std::array<double, 2>& diagonal(std::size_t axis) const { return diagonals_[axis]; }

 private:
  static Position along(const Diagonals& diagonals, double x, double y, double z) {
    Position place{};
    for (std::size_t i = 0; i < kAxes; ++i) {
      const auto& [of_y, of_z] = diagonals[i];
      place[i] = x + of_y * y + of_z * z;
    }
    return place;
  }

  Diagonals diagonals_;
  Position low_;
  Position high_;
};

/// The facets that one thread may replace, and the sites it inserts. Facets are those all of whose
/// corners are its sites, or those whose centers are in its box.
class Range {
 public:
  /// All facets and sites.
  Range() = default;
  explicit(false) Range(const SiteRange& sites) : sites_(sites) {}
  Range(const SiteRange& sites, const CenterBox& centers) : sites_(sites), centers_(centers) {}

  bool all() const { return sites_.all(); }
  const SiteRange& sites() const { return sites_; }
  /// Null if it goes by corners.
  const CenterBox* centers() const { return centers_ ? &*centers_ : nullptr; }
  bool owns(const Facet& f) const {
    return centers_ ? centers_->contains(f) : sites_.contains(f.links.corners);
  }
  /// The same of the facet behind a ridge of one that it owns: all other corners are that one's.
  bool owns_behind(const Facet& f, std::uint32_t corner) const {
    return centers_ ? centers_->contains(f) : sites_.contains(f.links.corners[corner]);
  }

 private:
  SiteRange sites_;
  std::optional<CenterBox> centers_;
};

}  // namespace tetsculpt::hull
