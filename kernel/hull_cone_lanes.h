#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "kernel/hull_facets.h"
#include "kernel/point.h"

/// What a cone computes for many corners and facets: four at a time where has_four_lanes(), one
/// after the other elsewhere. Internal to kernel/hull_cone.
namespace tetsculpt::hull {

/// Where a spoke is: so many doubles behind the first one. Spokes need not be one behind the other.
using SpokePlace = std::uint32_t;

/// Where a site's spoke is, in a table that holds the one to infinity before all others.
inline SpokePlace& spoke_of(SpokePlace* table, Site s) {
  return table[static_cast<std::int32_t>(s) + 1];
}

/// A new facet through an apex, its first corner, and a ridge of the horizon.
struct ConeFacet {
  FacetIndex facet;
  std::array<SpokePlace, 3> spokes;  ///< to its corners 1 to 3
};

/// Sees to it that each corner of the visible facets has a spoke from the apex, and takes away the
/// facets' marks. Facets come in the order in which they were met, each with the ridge through
/// which that was: it leaves one corner that may be new. The first four places are for the corners
/// of the first facet; each facet after it has one, for the corner opposite its ridge, and where
/// that is not new, the later place counts. `spoke_of` gets the place per site, after the one at
/// infinity.
void set_spokes(Facets& facets, std::span<const Point3> points, Site apex,
                std::span<const Ridge> visible, const SpokePlace* places, SpokePlace* table,
                Spoke* spokes);
/// The same four at a time, where has_four_lanes(): behind the visible facets the first of them
/// follows again, up to a multiple of four and one, each with a place.
void set_spokes_by_four(Facets& facets, std::span<const Point3> points, Site apex,
                        std::span<const Ridge> visible, const SpokePlace* places, SpokePlace* table,
                        Spoke* spokes);

/// Each directed edge of a horizon belongs to one facet of the cone, its reverse to the neighbour:
/// a table by pairs of spokes, in which every entry that is read was written just before.
class HalfRidges {
 public:
  HalfRidges() = default;
  explicit HalfRidges(Ridge* table) : table_(table) {}
  bool used() const { return table_ != nullptr; }
  /// How many ridges a table has if no place is beyond `last`.
  static std::size_t size(SpokePlace last) { return 3 * std::size_t{last} / 4 + 1; }
  Ridge& operator()(SpokePlace from, SpokePlace to) const {
    // A place is a multiple of four, which is the size of a ridge.
    return *reinterpret_cast<Ridge*>(reinterpret_cast<std::byte*>(table_) + (from + 2 * to));
  }

 private:
  Ridge* table_ = nullptr;
};

/// Links a cone's facets among each other, if the table is used, and sets their hyperplanes. Spokes
/// lead from the apex to the other corners.
void finish_cone(Facets& facets, Site apex, std::span<const ConeFacet> cone, const Spoke* spokes,
                 const HalfRidges& half_ridges);
/// The same four at a time, where has_four_lanes(): the cone's end is followed by facets of it up
/// to a multiple of four.
void finish_cone_by_four(Facets& facets, Site apex, std::span<const ConeFacet> cone,
                         const Spoke* spokes, const HalfRidges& half_ridges);

}  // namespace tetsculpt::hull
