// Each predicate is a polynomial in differences of coordinates, decided in four stages:
//   1. in doubles, with an error bound relative to the polynomial's permanent (all signs positive);
//   2. in 128-bit integers, where no difference is rounded and all fit;
//   3. in numbers of twice a double's digits, which hold all differences, with a bound as in 1;
//   4. exactly, in expansions.
//
// Error bounds, with u = 2^-53. A value computed through at most k roundings along any path from
// the inputs is off by at most ((1+u)^k - 1) P, P the permanent. The computed permanent is itself
// at least (1-u)^k P, so (k+1) u times it covers both for every k here (k < 30). In stage 3 the
// same holds with 2^-103 for u, but for P, which is computed in doubles as before: (k+2) covers
// that.
//
// Stage 3 took a fifth off the hull of a million points of a torus, whose tetrahedra have their
// corners nearly on one circle: expansions take ten times as long.
#include "kernel/predicates.h"

#include <array>
#include <cfloat>
#include <cmath>
#include <type_traits>
#include <utility>

#include "kernel/double_double.h"
#include "kernel/expansion.h"
#include "kernel/integer_differences.h"
#include "kernel/vec3.h"

#ifdef __FAST_MATH__
#error "exact predicates need IEEE semantics: build without -ffast-math"
#endif
static_assert(FLT_EVAL_METHOD == 0, "exact predicates need doubles that are rounded to double");

namespace tetsculpt {
namespace {

constexpr double kUnit = DBL_EPSILON / 2;

Vec3<double> rounded_difference(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

Vec3<Expansion> exact_difference(const Point3& a, const Point3& b, ExpansionArena& arena) {
  return {Expansion::difference(a.x, b.x, arena), Expansion::difference(a.y, b.y, arena),
          Expansion::difference(a.z, b.z, arena)};
}

Vec3<DoubleDouble> double_difference(const Point3& a, const Point3& b) {
  return {DoubleDouble::difference(a.x, b.x), DoubleDouble::difference(a.y, b.y),
          DoubleDouble::difference(a.z, b.z)};
}

/// The differences from one origin that a polynomial is made of.
template <class T, std::size_t N>
using Differences = std::array<Vec3<T>, N>;

/// The polynomial's value, where make(point) is the difference from the origin.
template <class Polynomial, std::size_t N, class Make>
auto value_of(const std::array<const Point3*, N>& points, Make&& make) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return Polynomial::value(Differences<decltype(make(*points[0]).x), N>{make(*points[i])...});
  }
  (std::make_index_sequence<N>{});
}

/// Stage 4. Apart, for the room on the stack.
template <class Polynomial, std::size_t N>
Sign decide_exactly(const std::array<const Point3*, N>& points, const Point3& origin) {
  ExpansionArena arena;
  return value_of<Polynomial>(points,
                              [&](const Point3& p) { return exact_difference(p, origin, arena); })
      .sign();
}

/// Is a value computed in doubles clear of its error?
template <class Polynomial>
bool is_clear(double value, double permanent) {
  return std::fabs(value) > (Polynomial::kRoundings + 1) * kUnit * permanent;
}

/// Stages 2 to 4.
template <class Polynomial, std::size_t N>
Sign decide_unclear(const std::array<const Point3*, N>& points, const Point3& origin,
                    double permanent) {
  if (permanent == 0) return Sign::kZero;  // no product is but of zero: on a coordinate plane

  if (const auto integers = integer_differences(points, origin, most_bits(Polynomial::kDegree))) {
    const Int128 exact = Polynomial::value(*integers);
    return sign_of(exact);
  }

  const DoubleDouble near =
      value_of<Polynomial>(points, [&](const Point3& p) { return double_difference(p, origin); });
  const double error = (Polynomial::kRoundings + 2) * DoubleDouble::kRounding * permanent;
  if (std::fabs(near.high) > error) return sign_of(near.high);
  return decide_exactly<Polynomial>(points, origin);
}

/// The ladder. `Polynomial` gives value(differences) over doubles and expansions,
/// permanent(absolute differences), kRoundings (k above) and kDegree.
template <class Polynomial, std::size_t N>
Sign decide(const std::array<const Point3*, N>& points, const Point3& origin) {
  Differences<double, N> rounded;
  Differences<double, N> magnitudes;
  for (std::size_t i = 0; i < N; ++i) {
    rounded[i] = rounded_difference(*points[i], origin);
    magnitudes[i] = abs(rounded[i]);
  }
  const double value = Polynomial::value(rounded);
  const double permanent = Polynomial::permanent(magnitudes);
  if (is_clear<Polynomial>(value, permanent)) return sign_of(value);
  return decide_unclear<Polynomial>(points, origin, permanent);
}

struct Orient3d {
  static constexpr int kRoundings = 8;
  static constexpr int kDegree = 3;
  template <class T>
  static T value(const Differences<T, 3>& d) {
    return dot(d[0], cross(d[1], d[2]));
  }
  static double permanent(const Differences<double, 3>& d) {
    return dot(d[0], cross_permanent(d[1], d[2]));
  }
};

/// The 4 x 4 determinant of the lifted differences, by 2 x 2 minors in x and y; the larger minors
/// and the determinant may be of a wider type.
struct Insphere {
  static constexpr int kRoundings = 16;
  static constexpr int kDegree = 5;
  template <class T, class Wide = T>
  static Wide value(const Differences<T, 4>& d) {
    const auto wide = [](const T& x) -> decltype(auto) {
      if constexpr (std::is_same_v<T, Wide>)
        return (x);
      else
        return Wide{x};
    };
    const auto& [a, b, c, e] = d;
    const T ab = a.x * b.y - b.x * a.y;
    const T bc = b.x * c.y - c.x * b.y;
    const T ce = c.x * e.y - e.x * c.y;
    const T ea = e.x * a.y - a.x * e.y;
    const T ac = a.x * c.y - c.x * a.y;
    const T be = b.x * e.y - e.x * b.y;
    const Wide abc = wide(a.z) * bc - wide(b.z) * ac + wide(c.z) * ab;
    const Wide bce = wide(b.z) * ce - wide(c.z) * be + wide(e.z) * bc;
    const Wide cea = wide(c.z) * ea + wide(e.z) * ac + wide(a.z) * ce;
    const Wide eab = wide(e.z) * ab + wide(a.z) * be + wide(b.z) * ea;
    return (dot(e, e) * abc - dot(c, c) * eab) + (dot(b, b) * cea - dot(a, a) * bce);
  }
  static double permanent(const Differences<double, 4>& d) {
    const auto& [a, b, c, e] = d;
    const double ab = a.x * b.y + b.x * a.y;
    const double bc = b.x * c.y + c.x * b.y;
    const double ce = c.x * e.y + e.x * c.y;
    const double ea = e.x * a.y + a.x * e.y;
    const double ac = a.x * c.y + c.x * a.y;
    const double be = b.x * e.y + e.x * b.y;
    return (dot(e, e) * (a.z * bc + b.z * ac + c.z * ab) +
            dot(c, c) * (e.z * ab + a.z * be + b.z * ea)) +
           (dot(b, b) * (c.z * ea + e.z * ac + a.z * ce) +
            dot(a, a) * (b.z * ce + c.z * be + e.z * bc));
  }
};

struct Diametral {
  static constexpr int kRoundings = 5;
  static constexpr int kDegree = 2;
  template <class T>
  static T value(const Differences<T, 2>& d) {
    return dot(d[0], d[1]);
  }
  static double permanent(const Differences<double, 2>& d) { return dot(d[0], d[1]); }
};

/// With u = b-a, v = c-a, e = p-a, w = u x v, the centre is a + ((w x u)|v|^2 + (v x w)|u|^2) /
/// 2|w|^2, and p is inside iff |e|^2 |w|^2 is less than e times that numerator: no division.
struct Equatorial {
  static constexpr int kRoundings = 19;
  static constexpr int kDegree = 6;
  template <class T>
  static T value(const Differences<T, 3>& d) {
    const auto& [u, v, e] = d;
    const Vec3<T> w = cross(u, v);
    return dot(e, cross(w, u) * dot(v, v) + cross(v, w) * dot(u, u)) - dot(e, e) * dot(w, w);
  }
  static double permanent(const Differences<double, 3>& d) {
    const auto& [u, v, e] = d;
    const Vec3<double> w = cross_permanent(u, v);
    return dot(e, cross_permanent(w, u) * dot(v, v) + cross_permanent(v, w) * dot(u, u)) +
           dot(e, e) * dot(w, w);
  }
};

/// With differences from a: w . ((b-p) x (c-p)) = w . (u x v - e x v - u x e), since both factors
/// are differences of u, v and e.
struct Barycentric {
  static constexpr int kRoundings = 13;
  static constexpr int kDegree = 4;
  template <class T>
  static T value(const Differences<T, 3>& d) {
    const auto& [u, v, e] = d;
    const Vec3<T> w = cross(u, v);
    return (dot(w, w) - dot(w, cross(e, v))) - dot(w, cross(u, e));
  }
  static double permanent(const Differences<double, 3>& d) {
    const auto& [u, v, e] = d;
    const Vec3<double> w = cross_permanent(u, v);
    return (dot(w, w) + dot(w, cross_permanent(e, v))) + dot(w, cross_permanent(u, e));
  }
};

}  // namespace

// The first stage without arrays, which the compiler keeps in memory: half as many instructions.
Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Vec3<double> p = rounded_difference(a, d);
  const Vec3<double> q = rounded_difference(b, d);
  const Vec3<double> r = rounded_difference(c, d);
  const double value = dot(p, cross(q, r));
  const double permanent = dot(abs(p), cross_permanent(abs(q), abs(r)));
  if (is_clear<Orient3d>(value, permanent)) return sign_of(value);
  return decide_unclear<Orient3d, 3>({&a, &b, &c}, d, permanent);
}

Sign insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  return decide<Insphere, 4>({&a, &b, &c, &d}, e);
}

std::optional<Sign> insphere_in_units(const Point3& a, const Point3& b, const Point3& c,
                                      const Point3& d, const Point3& e, double per_unit) {
  // Lifts and minors of differences below 2^23 fit in 64 bits, the determinant in 122.
  constexpr double kMost = 1 << most_bits(Insphere::kDegree);
  static_assert(kMost <= 1 << 23);
  Differences<std::int64_t, 4> integers;
  const std::array<const Point3*, 4> points{&a, &b, &c, &d};
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3<double> units = rounded_difference(*points[i], e) * per_unit;
    const Vec3<double> size = abs(units);
    if (!(size.x < kMost && size.y < kMost && size.z < kMost)) return std::nullopt;
    integers[i] = {static_cast<std::int64_t>(units.x), static_cast<std::int64_t>(units.y),
                   static_cast<std::int64_t>(units.z)};
  }
  return sign_of(Insphere::value<std::int64_t, Int128>(integers));
}

Sign in_diametral_sphere(const Point3& a, const Point3& b, const Point3& p) {
  return -decide<Diametral, 2>({&a, &b}, p);
}

Sign in_equatorial_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& p) {
  return decide<Equatorial, 3>({&b, &c, &p}, a);
}

Sign barycentric_sign(const Point3& a, const Point3& b, const Point3& c, const Point3& p) {
  return decide<Barycentric, 3>({&b, &c, &p}, a);
}

// |ab|^2 - |cd|^2 has two origins, so it has a ladder of its own: the differences' roundings and
// the square, sum and final subtraction make k = 2 + 1 + 2 + 1.
Sign compare_lengths(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Vec3<double> ab = rounded_difference(b, a);
  const Vec3<double> cd = rounded_difference(d, c);
  const double ab2 = dot(ab, ab);
  const double cd2 = dot(cd, cd);
  if (std::fabs(ab2 - cd2) > 7 * kUnit * (ab2 + cd2)) return sign_of(ab2 - cd2);
  ExpansionArena arena;
  const Vec3<Expansion> exact_ab = exact_difference(b, a, arena);
  const Vec3<Expansion> exact_cd = exact_difference(d, c, arena);
  return (dot(exact_ab, exact_ab) - dot(exact_cd, exact_cd)).sign();
}

bool collinear(const Point3& a, const Point3& b, const Point3& c) {
  const Vec3<double> u = rounded_difference(b, a);
  const Vec3<double> v = rounded_difference(c, a);
  const Vec3<double> w = abs(cross(u, v));
  const Vec3<double> bound = cross_permanent(abs(u), abs(v)) * (5 * kUnit);
  if (w.x > bound.x || w.y > bound.y || w.z > bound.z) return false;
  ExpansionArena arena;
  const Vec3<Expansion> exact = cross(exact_difference(b, a, arena), exact_difference(c, a, arena));
  return exact.x.sign() == Sign::kZero && exact.y.sign() == Sign::kZero &&
         exact.z.sign() == Sign::kZero;
}

}  // namespace tetsculpt
