#include "kernel/mesh_shape.h"

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "kernel/distinct_points.h"
#include "kernel/expansion.h"
#include "kernel/predicates.h"
#include "kernel/shell_nesting.h"

namespace tetsculpt {
namespace {

/// Six times a signed volume as a sum of terms, and what bounds its error.
struct RoundedVolume {
  double sum = 0;
  double magnitude = 0;  ///< the same sum of absolute values
  std::size_t terms = 0;

  /// Adds the tetrahedron from o to abc.
  void add(const Point3& o, const Point3& a, const Point3& b, const Point3& c) {
    const double ax = a.x - o.x, ay = a.y - o.y, az = a.z - o.z;
    const double bx = b.x - o.x, by = b.y - o.y, bz = b.z - o.z;
    const double cx = c.x - o.x, cy = c.y - o.y, cz = c.z - o.z;
    sum += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
    magnitude += std::fabs(ax) * (std::fabs(by * cz) + std::fabs(bz * cy)) +
                 std::fabs(ay) * (std::fabs(bz * cx) + std::fabs(bx * cz)) +
                 std::fabs(az) * (std::fabs(bx * cy) + std::fabs(by * cx));
    ++terms;
  }

  /// A product of three differences is off by at most 6 units of rounding, a term by 4 more, and
  /// each addition to the sum by one; twice that covers the rounding of the bound itself.
  bool certain() const {
    constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2;
    return std::fabs(sum) > 2 * kUnit * (10 + static_cast<double>(terms)) * magnitude;
  }
};

/// det(a, b, c), exactly.
Expansion determinant(const Point3& a, const Point3& b, const Point3& c, ExpansionArena& arena) {
  const auto n = [&](double x) { return Expansion::number(x, arena); };
  return n(a.x) * (n(b.y) * n(c.z) - n(b.z) * n(c.y)) +
         n(a.y) * (n(b.z) * n(c.x) - n(b.x) * n(c.z)) +
         n(a.z) * (n(b.x) * n(c.y) - n(b.y) * n(c.x));
}

/// The exact sign of the volume of closed shells whose rounded one does not tell.
class ExactVolume {
 public:
  void add(const Point3& a, const Point3& b, const Point3& c) {
    // A new arena now and then, with nothing but the sum in it.
    if (++terms_ % 256 == 0) {
      auto fresh = std::make_unique<ExpansionArena>();
      sum_ = Expansion::number(0, *fresh) + sum_;
      arena_ = std::move(fresh);
    }
    sum_ = sum_ + determinant(a, b, c, *arena_);
  }
  Sign sign() const { return sum_.sign(); }

 private:
  std::size_t terms_ = 0;
  std::unique_ptr<ExpansionArena> arena_ = std::make_unique<ExpansionArena>();
  Expansion sum_ = Expansion::number(0, *arena_);
};

bool closed_and_oriented(const Shell& shell) { return shell.closed_manifold() && shell.oriented; }

/// Works on a mesh in the range of exact arithmetic.
class Measure {
 public:
  Measure(const TriangleMesh& mesh, const MeshReport& report) : mesh_(mesh), report_(report) {
    shape_.shells.resize(report.shells.size());
  }

  MeshShape run() && {
    find_flat_triangles();
    find_volumes();
    find_outward();
    return std::move(shape_);
  }

 private:
  std::array<Point3, 3> corners(std::size_t t) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    return {mesh_.points[a], mesh_.points[b], mesh_.points[c]};
  }

  void find_flat_triangles() {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto [a, b, c] = corners(t);
      if (collinear(a, b, c)) shape_.flat_triangles.add(t);
    }
  }

  void find_volumes() {
    std::vector<RoundedVolume> volumes(shape_.shells.size());
    std::vector<std::uint32_t> origins(shape_.shells.size(), MeshReport::kNoShell);
    each_triangle([&](std::uint32_t shell, std::uint32_t t) {
      if (origins[shell] == MeshReport::kNoShell) origins[shell] = mesh_.triangles[t][0];
      const auto [a, b, c] = corners(t);
      volumes[shell].add(mesh_.points[origins[shell]], a, b, c);
    });
    bool all_certain = true;
    for (std::size_t i = 0; i < volumes.size(); ++i) {
      if (!closed_and_oriented(report_.shells[i])) continue;
      shape_.shells[i].volume = volumes[i].sum / 6;
      shape_.shells[i].facing = sign_of(volumes[i].sum);
      all_certain = all_certain && volumes[i].certain();
    }
    if (!all_certain) find_exact_signs(volumes);
  }

  void find_exact_signs(const std::vector<RoundedVolume>& volumes) {
    std::vector<std::unique_ptr<ExactVolume>> exact(volumes.size());
    each_triangle([&](std::uint32_t shell, std::uint32_t t) {
      if (volumes[shell].certain() || !closed_and_oriented(report_.shells[shell])) return;
      if (!exact[shell]) exact[shell] = std::make_unique<ExactVolume>();
      const auto [a, b, c] = corners(t);
      exact[shell]->add(a, b, c);
    });
    for (std::size_t i = 0; i < exact.size(); ++i) {
      if (exact[i]) shape_.shells[i].facing = exact[i]->sign();
    }
  }

  void find_outward() {
    std::vector<std::uint8_t> closed(shape_.shells.size());
    for (std::size_t i = 0; i < closed.size(); ++i) {
      closed[i] = closed_and_oriented(report_.shells[i]);
    }
    const auto depths = shell_depths(mesh_, report_.shell_of_point, closed);
    for (std::uint32_t i = 0; i < closed.size(); ++i) {
      ShellShape& shell = shape_.shells[i];
      shell.depth = depths[i];
      const Sign wanted = depths[i] % 2 == 0 ? Sign::kPositive : Sign::kNegative;
      shell.outward = closed[i] != 0 && shell.facing == wanted;
      if (closed[i] != 0 && !shell.outward) shape_.inverted_shells.add(i);
      shape_.volume += shell.volume;
    }
  }

  // Of a shell, in order.
  template <class Visit>
  void each_triangle(Visit&& visit) {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      const std::uint32_t shell = report_.shell_of_point[mesh_.triangles[t][0]];
      if (shell != MeshReport::kNoShell) visit(shell, t);
    }
  }

  const TriangleMesh& mesh_;
  const MeshReport& report_;
  MeshShape shape_;
};

}  // namespace

MeshShape measure(const TriangleMesh& mesh, const MeshReport& report) {
  const DistinctPoints distinct = distinct_points(mesh.points);
  TriangleMesh scaled{{}, mesh.triangles};
  scaled.points.reserve(mesh.points.size());
  for (const VertexId v : distinct.vertex_of_input) scaled.points.push_back(distinct.points[+v]);
  MeshShape shape = Measure(scaled, report).run();
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    if (distinct.first_input[+distinct.vertex_of_input[i]] != i) shape.repeated_points.add(i);
  }
  const int unit = -3 * distinct.scale_exponent;
  shape.volume = std::ldexp(shape.volume, unit);
  for (ShellShape& shell : shape.shells) shell.volume = std::ldexp(shell.volume, unit);
  return shape;
}

Faults<std::uint32_t> invalid_points(std::span<const Point3> points) {
  Faults<std::uint32_t> faults;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (!finite(points[i])) faults.add(i);
  }
  return faults;
}

}  // namespace tetsculpt
