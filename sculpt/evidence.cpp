// Evidence for inside and outside, from the points alone.
//
// 1. First guess. The two poles of a vertex lie on opposite sides of the surface, as surely as the
// angle
//    between them is straight; two tetrahedra whose circumspheres overlap deeply lie on the same
//    side, as surely as the cosine of the angle at which the spheres meet (N. Amenta, S. Choi, R.
//    K. Kolluri, "The power crust", Solid Modeling 2001). Labels spread from infinity, the most
//    certain first.
// 2. Bias. A vertex whose poles got different labels has an oriented normal. Each tetrahedron at
// the
//    vertex is drawn to the side on which its circumcentre lies, by the square of the cosine to the
//    normal; the two poles once more.
// 3. Facets. A surface that separates deeply overlapping spheres costs most: ((1 + cos) / 2)^2,
// plus a
//    little for every facet; less where the facet is a triangle of the EGH, which is likely there.
//
// The weights below were chosen over the closed models of bench/quality.py (figures in
// bench/RESULTS.md); none of them matters by more than two models within a factor of two.
#include "sculpt/evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

#include "sculpt/priority.h"

namespace tetsculpt {
namespace {

constexpr double kPoleWeight = 0.2;
constexpr double kNormalWeight = 0.3;
constexpr double kFacetWeight = 0.02;
constexpr double kEghFactor = 0.85;
/// Of an overlap with negative cosine, as evidence for opposite sides.
constexpr double kWeakOpposition = 0.5;

enum class Label : signed char { kOutside = -1, kUnknown = 0, kInside = 1 };

/// Spreads labels from infinity, as the power crust does for poles, over all tetrahedra.
class Propagation {
 public:
  Propagation(const TetComplex& complex, const Circumspheres& spheres,
              std::span<const PolePair> pairs)
      : complex_(complex),
        spheres_(spheres),
        pairs_(pairs),
        label_(complex.tet_count(), Label::kUnknown),
        for_inside_(complex.tet_count(), 0),
        for_outside_(complex.tet_count(), 0),
        queue_(Later{&complex}) {}

  std::vector<Label> run() {
    index_pairs();
    for (std::size_t t = complex_.finite_tet_count(); t < complex_.tet_count(); ++t) {
      label_[t] = Label::kOutside;
    }
    for (std::size_t t = complex_.finite_tet_count(); t < complex_.tet_count(); ++t) {
      spread(TetId{static_cast<std::uint32_t>(t)});
    }
    while (!queue_.empty()) {
      const Entry entry = queue_.top();
      queue_.pop();
      Label& label = label_[+entry.tet];
      if (label != Label::kUnknown || entry.certainty != certainty(entry.tet)) continue;
      label = for_inside_[+entry.tet] > for_outside_[+entry.tet] ? Label::kInside : Label::kOutside;
      spread(entry.tet);
    }
    return std::move(label_);
  }

 private:
  struct Entry {
    double certainty;
    TetId tet;
  };
  struct Later {
    const TetComplex* complex;
    bool operator()(const Entry& a, const Entry& b) const {
      return a.certainty != b.certainty ? a.certainty < b.certainty
                                        : corners_less(*complex, b.tet, a.tet);
    }
  };

  /// Lists, per tetrahedron, the vertices of which it is a pole.
  void index_pairs() {
    first_.assign(complex_.tet_count() + 1, 0);
    const auto for_each_pole = [&](auto&& visit) {
      for (std::uint32_t v = 0; v < pairs_.size(); ++v) {
        if (pairs_[v].strength <= 0) continue;
        visit(pairs_[v].first, v);
        visit(pairs_[v].second, v);
      }
    };
    for_each_pole([&](TetId t, std::uint32_t) { ++first_[+t + 1]; });
    for (std::size_t t = 0; t + 1 < first_.size(); ++t) first_[t + 1] += first_[t];
    vertex_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for_each_pole([&](TetId t, std::uint32_t v) { vertex_[next[+t]++] = v; });
  }

  double certainty(TetId t) const {
    const double in = for_inside_[+t];
    const double out = for_outside_[+t];
    return in > 0 && out > 0 ? std::fabs(in - out) - 1 : std::max(in, out);
  }

  void support(TetId t, bool inside, double strength) {
    if (label_[+t] != Label::kUnknown || strength <= 0) return;
    double& evidence = inside ? for_inside_[+t] : for_outside_[+t];
    if (strength <= evidence) return;
    evidence = strength;
    queue_.push({certainty(t), t});
  }

  /// Tells a tetrahedron's neighbours and opposite poles what its label means for them.
  void spread(TetId t) {
    const bool inside = label_[+t] == Label::kInside;
    for (std::uint32_t k = first_[+t]; k < first_[+t + 1]; ++k) {
      const PolePair& pair = pairs_[vertex_[k]];
      support(pair.first == t ? pair.second : pair.first, !inside, pair.strength);
    }
    for (int i = 0; i < 4; ++i) {
      const TetId u = complex_.neighbor(t, i);
      if (label_[+u] != Label::kUnknown) continue;
      const double overlap = spheres_.overlap(t, i);
      support(u, inside == (overlap > 0), overlap > 0 ? overlap : -overlap * kWeakOpposition);
    }
  }

  const TetComplex& complex_;
  const Circumspheres& spheres_;
  std::span<const PolePair> pairs_;
  std::vector<Label> label_;
  std::vector<double> for_inside_;
  std::vector<double> for_outside_;
  std::priority_queue<Entry, std::vector<Entry>, Later> queue_;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> vertex_;
};

/// Draws the tetrahedra at v to the sides of its oriented normal.
void add_bias(Evidence& evidence, VertexId v, const Vec3<double>& p, const Vec3<double>& outward,
              double strength, std::span<const TetId> star, const TetComplex& complex,
              const Circumspheres& spheres) {
  for (const TetId t : star) {
    if (!complex.finite(t) || !std::isfinite(spheres.radius(t))) continue;
    const Vec3<double> to = from_to(p, spheres.centre(t));
    const double distance = length(to);
    if (distance == 0) continue;
    const double cosine = dot(to, outward) / distance;
    evidence.inside_bias[+t] -= kNormalWeight * strength * cosine * std::fabs(cosine);
  }
  const auto draw = [&](TetId pole, double to_inside) {
    if (complex.finite(pole)) evidence.inside_bias[+pole] += kPoleWeight * strength * to_inside;
  };
  draw(evidence.believed[+v].inside, 1);
  draw(evidence.believed[+v].outside, -1);
}

double facet_cost(double overlap, bool in_egh) {
  const double closeness = (1 + overlap) / 2;
  return (kFacetWeight + closeness * closeness) * (in_egh ? kEghFactor : 1);
}

}  // namespace

Evidence weigh_evidence(std::span<const Point3> points, const TetComplex& complex,
                        const VertexStars& stars, const Circumspheres& spheres,
                        const Flags& egh_triangles) {
  Evidence evidence;
  evidence.inside_bias.assign(complex.finite_tet_count(), 0);
  evidence.believed.resize(points.size());
  const std::vector<PolePair> pairs = poles(points, complex, stars, spheres);
  const std::vector<Label> label = Propagation(complex, spheres, pairs).run();
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    const PolePair& pair = pairs[v];
    if (pair.strength <= 0 || label[+pair.first] == label[+pair.second]) continue;
    const bool first_inside = label[+pair.first] == Label::kInside;
    evidence.believed[v] = first_inside ? Evidence::Poles{pair.first, pair.second}
                                        : Evidence::Poles{pair.second, pair.first};
    add_bias(evidence, VertexId{v}, as_vector(points[v]), pair.axis * (first_inside ? -1.0 : 1.0),
             pair.strength, stars(VertexId{v}), complex, spheres);
  }
  evidence.facet_cost.resize(complex.triangle_count());
  for (std::uint32_t t = 0; t < complex.triangle_count(); ++t) {
    const Facet f = complex.facet(TriangleId{t});
    evidence.facet_cost[t] = facet_cost(spheres.overlap(f.tet, f.corner), egh_triangles[t] != 0);
  }
  return evidence;
}

}  // namespace tetsculpt
