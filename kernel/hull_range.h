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

/// A part of space, by where facets' spheres have their centers: a box along three of the four
/// diagonals of space. Each facet is in one of several that share out space, or in none.
class CenterBox {
 public:
  static constexpr std::size_t kAxes = 3;
  /// The first of three diagonals is one of so many.
  static constexpr std::size_t kDiagonals = 4;

  /// From a low corner on and below a high one, see place().
  CenterBox(std::size_t first_diagonal, const Position& low, const Position& high)
      : first_(first_diagonal), low_(low), high_(high) {}

  /// Where a point is that comes as its difference from the middle of the set.
  static Position place(std::size_t first_diagonal, const LiftedDifference& q) {
    return along(first_diagonal, 2 * q.x, 2 * q.y, 2 * q.z);
  }
  /// A facet's normal is twice its center, or beyond all points if it is infinite.
  bool contains(const Facet& f) const {
    const Position at = along(first_, f.nx, f.ny, f.nz);
    bool inside = true;
    for (std::size_t i = 0; i < kAxes; ++i) inside &= low_[i] <= at[i] && at[i] < high_[i];
    return inside;
  }
  double low(std::size_t axis) const { return low_[axis]; }
  double high(std::size_t axis) const { return high_[axis]; }
  /// What y and z are multiplied with before they are added to x: by one at a time and by four this
  /// must round alike.
  const std::array<double, 2>& signs(std::size_t axis) const { return diagonal(first_, axis); }

 private:
  static const std::array<double, 2>& diagonal(std::size_t first, std::size_t axis) {
    static constexpr std::array<std::array<double, 2>, kDiagonals> kSigns{
        {{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};
    return kSigns[(first + axis) % kDiagonals];
  }
  static Position along(std::size_t first, double x, double y, double z) {
    Position place{};
    for (std::size_t i = 0; i < kAxes; ++i) {
      const auto& [sign_y, sign_z] = diagonal(first, i);
      place[i] = x + sign_y * y + sign_z * z;
    }
    return place;
  }

  std::size_t first_;
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
