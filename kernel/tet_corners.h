#pragma once

#include <array>
#include <cstdint>

/// How the facets and edges of a tetrahedron are numbered by its corners.
namespace tetsculpt {

///        0          Tetrahedron (v0, v1, v2, v3): facet i is opposite corner i. orient3d of the
///       /|\         corners is positive, and facet i listed as kFacetCorners[i] looks
///      / | \        counterclockwise from outside. Edge k joins the corners kEdgeCorners[k];
///     1--|--3       edge 5 - k is opposite to it.
///      \ | /
///        2
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> kFacetCorners{
    {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};
inline constexpr std::array<std::array<std::uint8_t, 2>, 6> kEdgeCorners{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
/// The edge that joins two corners of a tetrahedron.
inline constexpr std::array<std::array<std::uint8_t, 4>, 4> kEdgeOfCorners{
    {{9, 0, 1, 2}, {0, 9, 3, 4}, {1, 3, 9, 5}, {2, 4, 5, 9}}};

}  // namespace tetsculpt
