#pragma once

#include <cstddef>
#include <cstdint>

/// Index types: one per kind of simplex, so that the wrong one does not compile. `+id` is its value
/// as an array index.
namespace tetsculpt {

/// Place of a point in the order of the distinct points; see kernel/distinct_points.h.
enum class VertexId : std::uint32_t {};
enum class EdgeId : std::uint32_t {};
enum class TriangleId : std::uint32_t {};
enum class TetId : std::uint32_t {};

/// The vertex at infinity, fourth corner of the infinite tetrahedra outside the convex hull.
inline constexpr VertexId kInfinite{0xffffffffu};

constexpr std::size_t operator+(VertexId id) { return static_cast<std::size_t>(id); }
constexpr std::size_t operator+(EdgeId id) { return static_cast<std::size_t>(id); }
constexpr std::size_t operator+(TriangleId id) { return static_cast<std::size_t>(id); }
constexpr std::size_t operator+(TetId id) { return static_cast<std::size_t>(id); }

}  // namespace tetsculpt
