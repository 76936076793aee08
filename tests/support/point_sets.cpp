#include "support/point_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "kernel/split_mix.h"

namespace tetsculpt::point_sets {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

/// Keeps points that are at least `spacing` from all kept before, by a grid of cells.
class Darts {
 public:
  explicit Darts(double spacing) : spacing_(spacing) {}

  bool keep(const Point3& p) {
    const std::array<long, 3> c{cell(p.x), cell(p.y), cell(p.z)};
    for (long x = c[0] - 1; x <= c[0] + 1; ++x) {
      for (long y = c[1] - 1; y <= c[1] + 1; ++y) {
        for (long z = c[2] - 1; z <= c[2] + 1; ++z) {
          const auto found = cells_.find({x, y, z});
          if (found == cells_.end()) continue;
          for (const std::size_t i : found->second) {
            const Point3& q = points_[i];
            if (std::hypot(p.x - q.x, p.y - q.y, p.z - q.z) < spacing_) return false;
          }
        }
      }
    }
    cells_[c].push_back(points_.size());
    points_.push_back(p);
    return true;
  }
  std::vector<Point3> points() { return std::move(points_); }

 private:
  long cell(double x) const { return static_cast<long>(std::floor(x / spacing_)); }
  double spacing_;
  std::vector<Point3> points_;
  std::map<std::array<long, 3>, std::vector<std::size_t>> cells_;
};

/// Throws darts until 2000 in a row miss: every gap is then hardly wider than the spacing.
template <class Throw>
std::vector<Point3> throw_darts(Darts darts, Throw&& next) {
  for (int misses = 0; misses < 2000;) misses = darts.keep(next()) ? 0 : misses + 1;
  return darts.points();
}

using Field = std::function<double(const Point3&)>;

/// Darts on the zero set of f: random points of the box, brought there by Newton steps.
std::vector<Point3> implicit_surface(const Field& f, const Point3& half_box, double spacing,
                                     std::uint64_t seed) {
  Random random(seed);
  return throw_darts(Darts(spacing), [&] {
    for (;;) {
      Point3 p{random.uniform(-half_box.x, half_box.x), random.uniform(-half_box.y, half_box.y),
               random.uniform(-half_box.z, half_box.z)};
      for (int step = 0; step < 30; ++step) {
        constexpr double h = 1e-6;
        const double v = f(p);
        const Point3 g{(f({p.x + h, p.y, p.z}) - v) / h, (f({p.x, p.y + h, p.z}) - v) / h,
                       (f({p.x, p.y, p.z + h}) - v) / h};
        const double g2 = g.x * g.x + g.y * g.y + g.z * g.z;
        if (!(g2 > 1e-12)) break;
        p = {p.x - v * g.x / g2, p.y - v * g.y / g2, p.z - v * g.z / g2};
        if (std::fabs(v) < 1e-11) return p;
      }
    }
  });
}

}  // namespace

std::uint64_t Random::bits() { return split_mix_next(state_); }

std::vector<Point3> shuffled(std::vector<Point3> points, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.below(i)]);
  return points;
}

std::vector<Point3> uniform_cube(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point3> points(n);
  for (Point3& p : points) p = {random.uniform(), random.uniform(), random.uniform()};
  return points;
}

std::vector<Point3> grid(std::size_t side, double spacing) {
  std::vector<Point3> points;
  for (std::size_t i = 0; i < side * side * side; ++i) {
    points.push_back({spacing * static_cast<double>(i / (side * side)),
                      spacing * static_cast<double>(i / side % side),
                      spacing * static_cast<double>(i % side)});
  }
  return points;
}

std::vector<Point3> random_lattice(std::size_t n, std::size_t side, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point3> points(n);
  const auto coordinate = [&] { return static_cast<double>(random.below(side)); };
  for (Point3& p : points) p = {coordinate(), coordinate(), coordinate()};
  return points;
}

std::vector<Point3> lattice_sphere(long squared_radius) {
  std::vector<Point3> points;
  const long r = static_cast<long>(std::sqrt(static_cast<double>(squared_radius))) + 1;
  for (long x = -r; x <= r; ++x) {
    for (long y = -r; y <= r; ++y) {
      const long rest = squared_radius - x * x - y * y;
      if (rest < 0) continue;
      const long z = std::lround(std::sqrt(static_cast<double>(rest)));
      if (z * z != rest) continue;
      const auto as_double = [](long i) { return static_cast<double>(i); };
      points.push_back({as_double(x), as_double(y), as_double(z)});
      if (z != 0) points.push_back({as_double(x), as_double(y), as_double(-z)});
    }
  }
  return points;
}

std::vector<Point3> skew_lines(std::size_t n) {
  std::vector<Point3> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i);
    points.push_back({t, 0, 0});
    points.push_back({0, t, 1000});
  }
  return points;
}

std::vector<Point3> plane_and_apex(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point3> points(n);
  for (Point3& p : points) p = {random.uniform(), random.uniform(), 0};
  points.push_back({0.5, 0.5, 1});
  return points;
}

std::vector<Point3> clusters(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point3> points(n);
  const auto near = [&](double place) { return place + 1e-12 * random.uniform(); };
  for (Point3& p : points) {
    const auto c = static_cast<double>(random.below(10));
    p = {near(c), near(c * c), near(c * c * c / 8)};
  }
  return points;
}

std::vector<Point3> bumpy_sphere(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point3> points(n);
  for (Point3& p : points) {
    const double z = random.uniform(-1, 1);
    const double phi = random.uniform(0, kTwoPi);
    const double theta = std::acos(z);
    const double r = 1 + 0.15 * std::sin(5 * theta) * std::sin(4 * phi);
    p = {r * std::sin(theta) * std::cos(phi), r * std::sin(theta) * std::sin(phi), r * z};
  }
  return points;
}

std::vector<Point3> random_torus(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point3> points;
  while (points.size() < n) {
    const double a = random.uniform(0, kTwoPi);
    const double b = random.uniform(0, kTwoPi);
    const double ring = 1 + 0.4 * std::cos(b);
    if (random.uniform(0, 1.4) > ring) continue;
    points.push_back({ring * std::cos(a), ring * std::sin(a), 0.4 * std::sin(b)});
  }
  return points;
}

std::vector<Point3> random_double_torus(std::size_t n, std::uint64_t seed) {
  // Points of a thin layer about the surface, brought onto it by Newton steps.
  constexpr double kHalfLayer = 0.02;
  Random random(seed);
  std::vector<Point3> points;
  while (points.size() < n) {
    Point3 p{random.uniform(-1.2, 1.2), random.uniform(-0.6, 0.6), random.uniform(-0.25, 0.25)};
    for (int step = 0; step < 6; ++step) {
      const double r2 = p.x * p.x + p.y * p.y;
      const double lemniscate = r2 * r2 - p.x * p.x + p.y * p.y;
      const double value = lemniscate * lemniscate + p.z * p.z - 0.02;
      const Point3 g{2 * lemniscate * p.x * (4 * r2 - 2), 2 * lemniscate * p.y * (4 * r2 + 2),
                     2 * p.z};
      const double g2 = g.x * g.x + g.y * g.y + g.z * g.z;
      if (step == 0 && !(value * value < kHalfLayer * kHalfLayer * g2)) break;
      p = {p.x - value * g.x / g2, p.y - value * g.y / g2, p.z - value * g.z / g2};
      if (step == 5) points.push_back(p);
    }
  }
  return points;
}

std::vector<Point3> sphere(double spacing, std::uint64_t seed) {
  const Field f = [](const Point3& p) { return p.x * p.x + p.y * p.y + p.z * p.z - 1; };
  return implicit_surface(f, {1, 1, 1}, spacing, seed);
}

std::vector<Point3> ellipsoid(double spacing, std::uint64_t seed) {
  const Field f = [](const Point3& p) {
    return p.x * p.x + p.y * p.y / 0.49 + p.z * p.z / 0.25 - 1;
  };
  return implicit_surface(f, {1, 0.7, 0.5}, spacing, seed);
}

std::vector<Point3> torus(double spacing, std::uint64_t seed) {
  const Field f = [](const Point3& p) {
    const double ring = std::hypot(p.x, p.y) - 1;
    return ring * ring + p.z * p.z - 0.16;
  };
  return implicit_surface(f, {1.4, 1.4, 0.4}, spacing, seed);
}

std::vector<Point3> double_torus(double spacing, std::uint64_t seed) {
  const Field f = [](const Point3& p) {
    const double r2 = p.x * p.x + p.y * p.y;
    const double lemniscate = r2 * r2 - p.x * p.x + p.y * p.y;
    return lemniscate * lemniscate + p.z * p.z - 0.02;
  };
  return implicit_surface(f, {1.2, 0.6, 0.2}, spacing, seed);
}

std::vector<Point3> cube_surface(double spacing, std::uint64_t seed) {
  Darts darts(spacing * (1 - 1e-9));
  const int steps = static_cast<int>(1 / spacing);
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    for (const double u : {0.0, 1.0}) {
      for (const double v : {0.0, 1.0}) {
        darts.keep({t, u, v});
        darts.keep({u, t, v});
        darts.keep({u, v, t});
      }
    }
  }
  Random random(seed);
  return throw_darts(std::move(darts), [&] {
    std::array<double, 3> c{random.uniform(), random.uniform(), random.uniform()};
    c[random.below(3)] = static_cast<double>(random.below(2));
    return Point3{c[0], c[1], c[2]};
  });
}

std::vector<Point3> translated(std::vector<Point3> points, const Point3& by) {
  for (Point3& p : points) p = {p.x + by.x, p.y + by.y, p.z + by.z};
  return points;
}

std::vector<Point3> scaled(std::vector<Point3> points, double by) {
  for (Point3& p : points) p = {p.x * by, p.y * by, p.z * by};
  return points;
}

std::vector<Point3> joined(std::vector<Point3> a, const std::vector<Point3>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace tetsculpt::point_sets
