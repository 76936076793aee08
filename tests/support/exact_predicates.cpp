// Notation: positions are relative to the first argument, so that its own terms vanish; power() is
// |x|^2 minus the linear function that interpolates |x|^2 at the simplex, which is the power of x
// with respect to the (smallest) sphere through the simplex. All values are scaled by one positive
// number.
#include "tests/support/exact_predicates.h"

#include <bit>
#include <climits>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <sstream>
#include <tuple>

#include "tests/support/exact_integer.h"

namespace tetsculpt::exact {
namespace {

struct Vector {
  ExactInteger x, y, z;
};

Vector operator-(const Vector& u, const Vector& v) { return {u.x - v.x, u.y - v.y, u.z - v.z}; }

ExactInteger dot(const Vector& u, const Vector& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }

ExactInteger determinant(const Vector& u, const Vector& v, const Vector& w) {
  return u.x * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) +
         u.z * (v.x * w.y - v.y * w.x);
}

int lowest_bit_exponent(double x) {
  if (x == 0) return INT_MAX;
  int exponent = 0;
  const double fraction = std::frexp(std::fabs(x), &exponent);
  return exponent - 53 + std::countr_zero(static_cast<std::uint64_t>(std::ldexp(fraction, 53)));
}

/// The points as integer vectors in a common unit, a power of two.
template <std::size_t kCount>
std::array<Vector, kCount> scaled(const std::array<Point3, kCount>& points) {
  int unit = INT_MAX;
  for (const Point3& p : points) {
    for (const double x : {p.x, p.y, p.z}) unit = std::min(unit, lowest_bit_exponent(x));
  }
  std::array<Vector, kCount> result;
  for (std::size_t i = 0; i < kCount; ++i) {
    result[i] = {ExactInteger::from_double(points[i].x, unit),
                 ExactInteger::from_double(points[i].y, unit),
                 ExactInteger::from_double(points[i].z, unit)};
  }
  return result;
}

/// A point against the sphere of a simplex: its power and the barycentric coordinates of its
/// projection on the simplex, all times `weight`, which is positive unless the simplex is
/// degenerate (or, for a tetrahedron, of negative orientation).
template <std::size_t kCorners>
struct SphereSide {
  ExactInteger power;
  ExactInteger weight;
  std::array<ExactInteger, kCorners> barycentric;
};

/// Fills in what follows: coordinates sum to one, the power from the squared edges at corner 0.
template <std::size_t kCorners>
void complete(SphereSide<kCorners>& side, const std::array<Vector, kCorners>& corners,
              const Vector& p) {
  side.barycentric[0] = side.weight;
  side.power = dot(p - corners[0], p - corners[0]) * side.weight;
  for (std::size_t i = 1; i < kCorners; ++i) {
    const Vector edge = corners[i] - corners[0];
    side.barycentric[0] = side.barycentric[0] - side.barycentric[i];
    side.power = side.power - dot(edge, edge) * side.barycentric[i];
  }
}

SphereSide<2> sphere_side(const Point3& a, const Point3& b, const Point3& p) {
  const auto [A, B, P] = scaled<3>({a, b, p});
  const Vector u = B - A;
  SphereSide<2> side;
  side.weight = dot(u, u);
  side.barycentric[1] = dot(u, P - A);
  complete<2>(side, {A, B}, P);
  return side;
}

/// The projection solves the normal equations with the Gram matrix of u and v.
SphereSide<3> sphere_side(const Point3& a, const Point3& b, const Point3& c, const Point3& p) {
  const auto [A, B, C, P] = scaled<4>({a, b, c, p});
  const Vector u = B - A, v = C - A, q = P - A;
  const ExactInteger uu = dot(u, u), uv = dot(u, v), vv = dot(v, v);
  const ExactInteger qu = dot(q, u), qv = dot(q, v);
  SphereSide<3> side;
  side.weight = uu * vv - uv * uv;
  side.barycentric[1] = qu * vv - qv * uv;
  side.barycentric[2] = qv * uu - qu * uv;
  complete<3>(side, {A, B, C}, P);
  return side;
}

/// Cramer's rule, with the sign that makes the weight of a positive orientation positive.
SphereSide<4> sphere_side(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                          const Point3& e) {
  const auto [A, B, C, D, E] = scaled<5>({a, b, c, d, e});
  const Vector u = B - A, v = C - A, w = D - A, q = E - A;
  SphereSide<4> side;
  side.weight = -determinant(u, v, w);
  side.barycentric[1] = -determinant(q, v, w);
  side.barycentric[2] = -determinant(u, q, w);
  side.barycentric[3] = -determinant(u, v, q);
  complete<4>(side, {A, B, C, D}, E);
  return side;
}

/// The sign of power + eps_p * weight - sum of barycentric[i] * eps_i: of the first coefficient
/// that isn't zero, from the lexicographically greatest point down. `points` ends with p.
template <std::size_t kCorners>
PerturbedSide perturbed(const SphereSide<kCorners>& side,
                        const std::array<Point3, kCorners + 1>& points) {
  if (side.power.sign() != Sign::kZero) {
    return {.inside = side.power.sign() == Sign::kNegative, .rank = -1, .argument = 0};
  }
  std::array<std::size_t, kCorners + 1> order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&points](std::size_t i, std::size_t j) {
    const Point3 &s = points[i], &t = points[j];
    return std::tie(s.x, s.y, s.z) > std::tie(t.x, t.y, t.z);
  });
  int rank = 0;
  for (const std::size_t i : order) {
    const Sign coefficient = i == kCorners ? side.weight.sign() : -side.barycentric[i].sign();
    if (coefficient != Sign::kZero) {
      return {.inside = coefficient == Sign::kNegative, .rank = rank, .argument = i};
    }
    ++rank;
  }
  throw std::domain_error("degenerate simplex");
}

}  // namespace

Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const auto [A, B, C, D] = scaled<4>({a, b, c, d});
  return -determinant(B - A, C - A, D - A).sign();
}

Sign insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  return -sphere_side(a, b, c, d, e).power.sign();
}

Sign in_diametral_sphere(const Point3& a, const Point3& b, const Point3& p) {
  const auto [A, B, P] = scaled<3>({a, b, p});
  return -dot(P - A, P - B).sign();
}

Sign in_equatorial_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& p) {
  return -sphere_side(a, b, c, p).power.sign();
}

Sign barycentric_sign(const Point3& a, const Point3& b, const Point3& c, const Point3& p) {
  return sphere_side(a, b, c, p).barycentric[0].sign();
}

Sign compare_lengths(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const auto [A, B, C, D] = scaled<4>({a, b, c, d});
  return (dot(A - B, A - B) - dot(C - D, C - D)).sign();
}

bool collinear(const Point3& a, const Point3& b, const Point3& c) {
  return sphere_side(a, b, c, a).weight.sign() == Sign::kZero;
}

PerturbedSide in_perturbed_sphere(const Point3& a, const Point3& b, const Point3& c,
                                  const Point3& d, const Point3& e) {
  return perturbed<4>(sphere_side(a, b, c, d, e), {a, b, c, d, e});
}

PerturbedSide in_perturbed_diametral_sphere(const Point3& a, const Point3& b, const Point3& p) {
  return perturbed<2>(sphere_side(a, b, p), {a, b, p});
}

PerturbedSide in_perturbed_equatorial_sphere(const Point3& a, const Point3& b, const Point3& c,
                                             const Point3& p) {
  return perturbed<3>(sphere_side(a, b, c, p), {a, b, c, p});
}

std::int64_t six_volumes(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const auto difference = [&a](const Point3& p) {
    return std::array{std::int64_t(p.x - a.x), std::int64_t(p.y - a.y), std::int64_t(p.z - a.z)};
  };
  const auto u = difference(b), v = difference(c), w = difference(d);
  return std::abs(u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
                  u[2] * (v[0] * w[1] - v[1] * w[0]));
}

void Agreement::add(Sign expected, Sign actual, std::span<const Point3> points) {
  ++count_[static_cast<std::size_t>(int(expected) + 1)];
  if (expected == actual) return;
  if (++failures_ > 1) return;
  std::ostringstream out;
  out << "expected " << int(expected) << ", got " << int(actual) << std::hexfloat;
  for (const Point3& p : points) out << "\n  {" << p.x << ", " << p.y << ", " << p.z << "}";
  first_failure_ = out.str();
}

bool Agreement::covers_all_signs(int percent) const {
  const std::int64_t total = std::accumulate(count_.begin(), count_.end(), std::int64_t{0});
  return std::all_of(count_.begin(), count_.end(), [total, percent](std::int64_t count) {
    return count > 0 && count * 100 >= total * percent;
  });
}

std::string Agreement::summary() const {
  std::ostringstream out;
  out << "negative " << occurrences(Sign::kNegative) << ", zero " << occurrences(Sign::kZero)
      << ", positive " << occurrences(Sign::kPositive) << ", failures " << failures_;
  if (failures_ > 0) out << "; first: " << first_failure_;
  return out.str();
}

}  // namespace tetsculpt::exact
