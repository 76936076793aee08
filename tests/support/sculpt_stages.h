#pragma once

#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/point.h"
#include "kernel/tet_complex.h"
#include "kernel/triangle_mesh.h"
#include "kernel/vertex_stars.h"
#include "sculpt/manifold_solid.h"
#include "sculpt/sculpt_paper.h"
#include "sculpt/sculpture.h"

/// The stages before sculpting, and the point sets that the sculpting tests share.
namespace tetsculpt::testing {

/// All that sculpt_paper takes.
struct Stages {
  DistinctPoints distinct;
  TetComplex complex;
  Constraints constraints;

  std::span<const Point3> points() const { return distinct.points; }
  std::vector<TetId> tets() const;  ///< the finite ones
  /// Nothing removed yet.
  ManifoldSolid solid() const { return {points(), complex, constraints}; }
  /// Each finite tetrahedron inside with this probability.
  Flags random_labels(double share, std::uint64_t seed) const;
  /// The boundary of what is inside, over all vertices.
  TriangleMesh surface(const Flags& inside) const;
  bool all_stars_good(const VertexStars& stars, const Flags& inside) const;
  Sculpture sculpt(Criterion criterion = Criterion::kConstrained,
                   PaperOptions::Stop stop = PaperOptions::Stop::kHeapEmpty) const;
};

Stages stages(std::span<const Point3> input);
/// The same over a complex that is given.
Stages stages(DistinctPoints distinct, TetComplex complex);

/// The same complex with its tetrahedra numbered otherwise.
TetComplex renumbered(const TetComplex& complex, std::uint64_t seed);

/// A point set with the words that make it anew, seed included.
struct NamedSet {
  std::string name;
  std::vector<Point3> points;
  friend std::ostream& operator<<(std::ostream& out, const NamedSet& set) {
    return out << set.name;
  }
};

/// Up to about 60 points: random in a box, on lattices, on lattice spheres, and in clusters; all
/// span a solid.
std::vector<NamedSet> small_sets();
/// 150 to 450 points, sampled from closed surfaces of genus 0, 1 and 2, and two spheres apart.
std::vector<NamedSet> bodies();

/// 13 points, of which the paper's own criterion leaves one hidden. Found by a search among
/// clusters.
std::vector<Point3> set_with_hidden_point();

inline constexpr Criterion kAllCriteria[] = {Criterion::kMinimalArea, Criterion::kGamma,
                                             Criterion::kLongestEdge, Criterion::kConstrained};

}  // namespace tetsculpt::testing
