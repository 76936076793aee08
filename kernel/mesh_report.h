#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/triangle_mesh.h"

/// What a mesh is and what is wrong with it, judged from its triangles alone.
namespace tetsculpt {

/// The places of one kind of fault: how many, and the first of them.
template <class Place>
struct Faults {
  std::size_t count = 0;
  Place first{};

  void add(const Place& place) {
    if (count++ == 0) first = place;
  }
};

/// A connected component, by shared vertices.
struct Shell {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t triangles = 0;
  std::size_t boundary_loops = 0;
  bool manifold = true;  ///< at its edges and its vertices
  bool oriented = true;
  bool closed_manifold() const { return manifold && boundary_loops == 0; }
  /// V - E + F + loops = 2 - 2 genus; none unless manifold and oriented.
  std::optional<std::size_t> genus() const;
};

/// Triangles with two corners at one index are counted as degenerate and then left out of all else.
/// Edges are two indices, the lower one first, and ascend; vertices and triangles are indices.
struct MeshReport {
  using Edge = std::array<std::uint32_t, 2>;
  static constexpr std::uint32_t kNoShell = 0xffffffffu;

  std::size_t vertices = 0;  ///< that are a corner
  std::size_t edges = 0;
  std::size_t triangles = 0;

  Faults<std::uint32_t> unused_points;
  Faults<std::uint32_t> degenerate;     ///< triangles with equal corners
  Faults<std::uint32_t> duplicates;     ///< triangles with the corners of an earlier one
  Faults<Edge> open_edges;              ///< with one triangle
  Faults<Edge> crowded_edges;           ///< with more than two
  Faults<Edge> misdirected_edges;       ///< along which two run in the same direction
  Faults<std::uint32_t> torn_vertices;  ///< whose triangles are not one cycle or one fan
  std::size_t boundary_loops = 0;       ///< closed chains of open edges; at crowded ones they end

  std::vector<Shell> shells;                  ///< by their lowest vertices
  std::vector<std::uint32_t> shell_of_point;  ///< kNoShell if unused

  /// Not empty, and every edge has exactly two triangles.
  bool closed() const { return edges > 0 && open_edges.count + crowded_edges.count == 0; }
};

/// Judges `mesh`. Precondition: no index is out of range.  Cost: a sort of the half-edges.
MeshReport judge(const TriangleMesh& mesh);

}  // namespace tetsculpt
