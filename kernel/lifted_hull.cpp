// Quickhull (C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The Quickhull algorithm for convex hulls",
// ACM Transactions on Mathematical Software 22(4), 1996) on the lifted points and the point at
// infinity above them (K. Q. Brown, "Voronoi diagrams from convex hulls", Information Processing
// Letters 9(5), 1979). Each facet keeps the points that see it, farthest first; take a facet's
// farthest point, find the facets it sees and their horizon, put a cone over the horizon, hand the
// orphans on.
//
// Departures: conflict sets hold one batch of points at a time, neighbours on a Hilbert curve
// within a round of a biased random order (kernel/insertion_order): a point is then handed on a few
// times instead of 4 ln n, and the facets in use stay in cache. A batch's points find their first
// facet by walking down the power of the facets' spheres, from where the last one ended. No point
// is ever discarded: all lifted points are extreme.
//
// What it brought, hull alone: one cache line per facet tested instead of five 10 %; rounds of
// seven times all before instead of once 25 % (a round streams all facets through the cache);
// batches of 16 instead of whole rounds 25 %; large pages half (page faults and TLB misses).
#include "kernel/lifted_hull.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "kernel/distinct_points.h"
#include "kernel/first_simplex.h"
#include "kernel/hull_facets.h"
#include "kernel/insertion_order.h"
#include "kernel/large_array.h"
#include "kernel/predicates.h"

namespace tetsculpt {
namespace {

using hull::corner_of;
using hull::facet_of;
using hull::FacetIndex;
using hull::Facets;
using hull::kAtInfinity;
using hull::kNone;
using hull::LiftedDifference;
using hull::Ridge;
using hull::ridge;
using hull::Site;

/// A ridge between a visible facet and one that is not, as the cone's new facet will hold it.
struct HorizonRidge {
  std::array<Site, 3> corners;  ///< with the apex first, these make a positively oriented facet
  Ridge outer;                  ///< seen from the facet that stays
};

/// One point's conflict with the hull.
struct Conflict {
  FacetIndex facet = kNone;  ///< the facet whose set holds the point; kNone once it is in
  Site next = kNone;         ///< the next point of that set
  double height = 0;         ///< above that facet's hyperplane, up to rounding
};

constexpr Site kBatch = 16;                   ///< points that are in conflict sets at a time
constexpr Site kReportEvery = 4096 * kBatch;  ///< points

class Worker {
 public:
  Worker(std::span<const Point3> sites, double unit);
  void run(const std::array<std::uint32_t, 4>& simplex,
           const std::function<void(double)>& progress);
  LiftedHull result(std::span<const VertexId> vertices) const;

 private:
  void make_simplex(const std::array<std::uint32_t, 4>& simplex);
  void insert(Site apex, FacetIndex seen);
  // The four steps of Quickhull.
  Site pick_apex(FacetIndex f) const { return facets_.farthest(f); }
  void find_horizon(Site apex, FacetIndex seen);
  void make_cone(Site apex);
  void reassign_conflicts(Site apex);

  Conflict& conflict(Site q) { return conflicts_[q - batch_begin_]; }
  FacetIndex locate(Site q, FacetIndex from) const;
  FacetIndex locate_exactly(Site q, FacetIndex from) const;
  void add_conflict(Site q, FacetIndex f, double height);
  void collect_orphans(Site apex);
  void number_horizon(Site apex);
  void link_cone();
  void link_large_cone();
  LargeArray<std::uint32_t> final_indices(std::span<const VertexId> vertices,
                                          std::size_t& finite_count) const;

  std::span<const Point3> sites_;
  mutable Facets facets_;
  std::array<Conflict, kBatch> conflicts_{};
  Site batch_begin_ = 0;
  std::uint32_t stamp_ = 0;
  FacetIndex last_ = 0;           ///< a facet that is alive
  std::vector<FacetIndex> free_;  ///< facets that died without a successor
  // Of the insertion under way:
  std::vector<FacetIndex> visible_;
  std::vector<HorizonRidge> horizon_;
  std::vector<Site> orphans_;
  std::vector<FacetIndex> cone_;                     ///< new facet per horizon ridge
  std::vector<std::array<std::uint32_t, 3>> local_;  ///< its corners' numbers among the horizon's
  std::vector<LiftedDifference> spokes_;             ///< per number, the corner minus the apex
  std::uint32_t infinite_number_ = kNone;
  struct Number {
    std::uint32_t stamp;  ///< of the insertion in which it counts
    std::uint32_t number;
  };
  LargeArray<Number> number_of_;   ///< per site and, last, the one at infinity
  std::vector<Ridge> half_ridge_;  ///< per ordered pair of numbers
};

constexpr std::size_t kLargeCone =
    256;  // above so many corners, pairs are sorted instead of tabulated

Worker::Worker(std::span<const Point3> sites, double unit)
    : sites_(sites),
      facets_(sites, unit),
      number_of_(sites.size() + 1, Number{0, 0}),
      half_ridge_(kLargeCone * kLargeCone) {
  facets_.reserve(9 * sites.size() + 64);
}

/// The tetrahedron and its four infinite facets, each made by putting infinity in a corner's place.
void Worker::make_simplex(const std::array<std::uint32_t, 4>& simplex) {
  const FacetIndex tet = facets_.append();
  facets_.corners(tet) = simplex;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const FacetIndex f = facets_.append();
    auto& c = facets_.corners(f);
    // Infinity in place of corner i, then exchange two corners: the shared ridge turns around.
    c = simplex;
    c[i] = kAtInfinity;
    std::swap(c[(i + 1) & 3], c[(i + 2) & 3]);
    if (i == 0) std::swap(c[0], c[1]), std::swap(c[2], c[3]);
  }
  // Five facets, each pair shares the ridge of its common corners.
  for (FacetIndex f = 0; f < 5; ++f) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      for (FacetIndex g = 0; g < 5; ++g) {
        for (std::uint32_t j = 0; j < 4 && g != f; ++j) {
          auto a = facets_.corners(f);
          auto b = facets_.corners(g);
          if (a[i] == b[j]) continue;
          a[i] = b[j] = 0;
          std::sort(a.begin(), a.end());
          std::sort(b.begin(), b.end());
          if (a == b) facets_.neighbors(f)[i] = ridge(g, j);
        }
      }
    }
  }
  for (FacetIndex f = 0; f < 5; ++f) facets_.set_hyperplane(f);
}

void Worker::run(const std::array<std::uint32_t, 4>& simplex,
                 const std::function<void(double)>& progress) {
  make_simplex(simplex);
  std::vector<bool> in_simplex(sites_.size(), false);
  for (const Site s : simplex) in_simplex[s] = true;
  const auto n = static_cast<Site>(sites_.size());
  for (Site begin = 0; begin < n; begin += kBatch) {
    const Site end = std::min(begin + kBatch, n);
    batch_begin_ = begin;
    for (Site q = begin; q < end; ++q) {
      if (in_simplex[q]) continue;
      last_ = locate(q, last_);
      add_conflict(q, last_, facets_.height(last_, q).value);
    }
    for (Site q = begin; q < end; ++q) {
      while (conflict(q).facet != kNone) insert(pick_apex(conflict(q).facet), conflict(q).facet);
    }
    if (progress && begin % kReportEvery == 0) {
      progress(static_cast<double>(begin) / static_cast<double>(n));
    }
  }
}

void Worker::insert(Site apex, FacetIndex seen) {
  find_horizon(apex, seen);
  collect_orphans(apex);
  number_horizon(apex);
  make_cone(apex);
  reassign_conflicts(apex);
}

/// Grows the visible region from a facet that the apex sees; what it is cut off by is the horizon.
void Worker::find_horizon(Site apex, FacetIndex seen) {
  stamp_ += 2;
  const std::uint32_t is_visible = stamp_;
  const std::uint32_t is_hidden = stamp_ + 1;
  visible_.assign(1, seen);
  horizon_.clear();
  facets_.mark(seen) = is_visible;
  for (std::size_t k = 0; k < visible_.size(); ++k) {
    const FacetIndex f = visible_[k];
    facets_.prefetch_neighbors(f);
    const auto neighbors = facets_.neighbors(f);
    for (std::uint32_t i = 0; i < 4; ++i) {
      const FacetIndex g = facet_of(neighbors[i]);
      std::uint32_t& mark = facets_.mark(g);
      if (mark == is_visible) continue;
      if (mark != is_hidden) {
        if (facets_.visible(g, apex)) {
          mark = is_visible;
          visible_.push_back(g);
          continue;
        }
        mark = is_hidden;
      }
      // The apex takes corner i's place; a double exchange, which keeps the orientation, puts it
      // first.
      const auto& c = facets_.corners(f);
      static constexpr std::uint8_t kOthers[4][3] = {{1, 2, 3}, {0, 3, 2}, {3, 0, 1}, {2, 1, 0}};
      horizon_.push_back({{c[kOthers[i][0]], c[kOthers[i][1]], c[kOthers[i][2]]}, neighbors[i]});
    }
  }
}

void Worker::collect_orphans(Site apex) {
  orphans_.clear();
  for (const FacetIndex f : visible_) {
    for (Site q = facets_.farthest(f); q != kNone; q = conflict(q).next) {
      if (q != apex) orphans_.push_back(q);
    }
    facets_.farthest(f) = kNone;
  }
}

/// Numbers the horizon's corners from 0 and computes their differences from the apex.
void Worker::number_horizon(Site apex) {
  spokes_.clear();
  local_.clear();
  infinite_number_ = kNone;
  for (const HorizonRidge& r : horizon_) {
    std::array<std::uint32_t, 3> numbers;
    for (std::size_t i = 0; i < 3; ++i) {
      const Site s = r.corners[i];
      const std::size_t at = s == kAtInfinity ? sites_.size() : s;
      if (number_of_[at].stamp != stamp_) {
        number_of_[at] = {stamp_, static_cast<std::uint32_t>(spokes_.size())};
        if (s == kAtInfinity) {
          infinite_number_ = number_of_[at].number;
          spokes_.push_back({});
        } else {
          spokes_.push_back(hull::lifted_difference(sites_[s], sites_[apex]));
        }
      }
      numbers[i] = number_of_[at].number;
    }
    local_.push_back(numbers);
  }
}

/// Replaces the visible facets by one facet per horizon ridge, each with the apex as first corner.
void Worker::make_cone(Site apex) {
  free_.insert(free_.end(), visible_.begin(), visible_.end());
  cone_.clear();
  const auto spoke = [&](std::uint32_t number) {
    return number == infinite_number_ ? nullptr : &spokes_[number];
  };
  for (std::size_t k = 0; k < horizon_.size(); ++k) {
    FacetIndex f;
    if (free_.empty()) {
      f = facets_.append();
    } else {
      f = free_.back();
      free_.pop_back();
    }
    const HorizonRidge& r = horizon_[k];
    facets_.corners(f) = {apex, r.corners[0], r.corners[1], r.corners[2]};
    facets_.neighbors(f)[0] = r.outer;
    facets_.neighbors(facet_of(r.outer))[corner_of(r.outer)] = ridge(f, 0);
    facets_.mark(f) = 0;
    facets_.set_hyperplane(f, spoke(local_[k][0]), spoke(local_[k][1]), spoke(local_[k][2]));
    cone_.push_back(f);
  }
  if (spokes_.size() <= kLargeCone) {
    link_cone();
  } else {
    link_large_cone();
  }
  last_ = cone_[0];
}

/// Each directed edge of the horizon belongs to one ridge, its reverse to the neighbour: a table by
/// pairs of numbers, in which every entry read was written just before.
void Worker::link_cone() {
  const std::size_t stride = spokes_.size();
  for (std::size_t k = 0; k < cone_.size(); ++k) {
    const auto [a, b, c] = local_[k];
    half_ridge_[b * stride + c] = ridge(cone_[k], 1);
    half_ridge_[c * stride + a] = ridge(cone_[k], 2);
    half_ridge_[a * stride + b] = ridge(cone_[k], 3);
  }
  for (std::size_t k = 0; k < cone_.size(); ++k) {
    const auto [a, b, c] = local_[k];
    auto& neighbors = facets_.neighbors(cone_[k]);
    neighbors[1] = half_ridge_[c * stride + b];
    neighbors[2] = half_ridge_[a * stride + c];
    neighbors[3] = half_ridge_[b * stride + a];
  }
}

void Worker::link_large_cone() {
  struct Half {
    std::uint64_t edge;  ///< unordered pair of numbers
    Ridge ridge;
  };
  std::vector<Half> halves;
  halves.reserve(3 * cone_.size());
  for (std::size_t k = 0; k < cone_.size(); ++k) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint64_t a = local_[k][(i + 1) % 3];
      const std::uint64_t b = local_[k][(i + 2) % 3];
      halves.push_back({std::min(a, b) << 32 | std::max(a, b), ridge(cone_[k], i + 1)});
    }
  }
  std::sort(halves.begin(), halves.end(),
            [](const Half& a, const Half& b) { return a.edge < b.edge; });
  for (std::size_t h = 0; h < halves.size(); h += 2) {
    assert(halves[h].edge == halves[h + 1].edge);
    const Ridge a = halves[h].ridge;
    const Ridge b = halves[h + 1].ridge;
    facets_.neighbors(facet_of(a))[corner_of(a)] = b;
    facets_.neighbors(facet_of(b))[corner_of(b)] = a;
  }
}

/// Hands each orphan to a facet of the cone that it sees; there is one, because an orphan saw a
/// facet that is gone and still lies outside the hull.
void Worker::reassign_conflicts(Site apex) {
  conflict(apex).facet = kNone;
  for (const Site q : orphans_) {
    const auto clearly_seen = [&](FacetIndex f) {
      const Facets::Height h = facets_.height(f, q);
      return h.value > h.error;
    };
    auto f = std::find_if(cone_.begin(), cone_.end(), clearly_seen);
    if (f == cone_.end()) {
      f = std::find_if(cone_.begin(), cone_.end(),
                       [&](FacetIndex g) { return facets_.visible(g, q); });
    }
    assert(f != cone_.end());
    add_conflict(q, *f, facets_.height(*f, q).value);
  }
}

/// Puts q into f's conflict set: first if it is the farthest, else second.
void Worker::add_conflict(Site q, FacetIndex f, double height) {
  Site& first = facets_.farthest(f);
  if (first == kNone || height > conflict(first).height) {
    conflict(q) = {f, first, height};
    first = q;
  } else {
    conflict(q) = {f, conflict(first).next, height};
    conflict(first).next = q;
  }
}

/// A facet that q sees. Walks to neighbours whose sphere has the smaller power of q, which is the
/// side of their common triangle's plane on which q lies; every step is a few multiply-adds, and
/// the walk may end as soon as the power is negative. Rounding can only end it early.
FacetIndex Worker::locate(Site q, FacetIndex from) const {
  FacetIndex f = from;
  if (const auto i = facets_.infinite_corner(f); i != 4) {
    if (facets_.visible(f, q)) return f;
    f = facet_of(facets_.neighbors(f)[i]);
  }
  Facets::Height h = facets_.height(f, q);
  if (h.value > h.error) return f;
  double power = facets_.power(f, h);
  for (bool moved = true; moved;) {
    moved = false;
    for (const Ridge r : facets_.neighbors(f)) {
      const FacetIndex g = facet_of(r);
      h = facets_.height(g, q);
      if (h.value > h.error) return g;
      if (facets_.infinite_corner(g) != 4) continue;
      const double power_g = facets_.power(g, h);
      if (power_g < power) {
        f = g;
        power = power_g;
        moved = true;
        break;
      }
    }
  }
  return locate_exactly(q, f);
}

/// Visibility walk by exact orientations: ends in the tetrahedron that holds q, or beyond the hull.
/// It ends because the power of q falls with every step.
FacetIndex Worker::locate_exactly(Site q, FacetIndex from) const {
  FacetIndex f = from;
  for (bool moved = true; moved;) {
    moved = false;
    for (std::uint32_t i = 0; i < 4; ++i) {
      auto p = facets_.corners(f);
      p[i] = q;
      if (orient3d(sites_[p[0]], sites_[p[1]], sites_[p[2]], sites_[p[3]]) != Sign::kNegative) {
        continue;
      }
      f = facet_of(facets_.neighbors(f)[i]);
      if (facets_.infinite_corner(f) != 4) return f;
      moved = true;
      break;
    }
  }
  return f;
}

/// New indices of the facets that live: finite ones first, either kind by its lowest corner.
/// Neighbours in space are then neighbours in memory for all later stages.
LargeArray<std::uint32_t> Worker::final_indices(std::span<const VertexId> vertices,
                                                std::size_t& finite_count) const {
  std::vector<bool> dead(facets_.size(), false);
  for (const FacetIndex f : free_) dead[f] = true;
  const std::size_t n = sites_.size();
  const auto bucket = [&](FacetIndex f) {
    std::size_t first = n;
    for (const Site s : facets_.corners(f)) {
      if (s != kAtInfinity) first = std::min<std::size_t>(first, +vertices[s]);
    }
    return facets_.infinite_corner(f) != 4 ? n + first : first;
  };
  LargeArray<std::uint32_t> next(2 * n + 1, 0);
  for (FacetIndex f = 0; f < facets_.size(); ++f) {
    if (!dead[f]) ++next[bucket(f) + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  finite_count = next[n];
  LargeArray<std::uint32_t> index(facets_.size(), kNone);
  for (FacetIndex f = 0; f < facets_.size(); ++f) {
    if (!dead[f]) index[f] = next[bucket(f)]++;
  }
  return index;
}

/// Where the corners of a facet go when its vertices are put in ascending order, infinity last; the
/// last two change places if that keeps the orientation.
std::array<std::uint8_t, 4> places_in_order(const std::array<VertexId, 4>& corners) {
  std::array<std::uint64_t, 4> keys;
  for (std::size_t i = 0; i < 4; ++i) keys[i] = std::uint64_t{+corners[i]} << 2 | i;
  bool odd = false;
  const auto order = [&](std::size_t i, std::size_t j) {
    const bool swap = keys[i] > keys[j];
    const std::uint64_t low = swap ? keys[j] : keys[i];
    keys[j] = swap ? keys[i] : keys[j];
    keys[i] = low;
    odd ^= swap;
  };
  order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
  std::array<std::uint8_t, 4> places;
  for (std::uint8_t place = 0; place < 4; ++place) places[keys[place] & 3] = place;
  if (odd) std::swap(places[keys[2] & 3], places[keys[3] & 3]);
  return places;
}

LiftedHull Worker::result(std::span<const VertexId> vertices) const {
  LiftedHull out;
  const LargeArray<std::uint32_t> index = final_indices(vertices, out.finite_count);
  const std::size_t count = facets_.size() - free_.size();
  out.tets.resize(count);
  out.neighbors.resize(count);
  LargeArray<std::array<std::uint8_t, 4>> places(facets_.size());
  for (FacetIndex f = 0; f < facets_.size(); ++f) {
    if (index[f] == kNone) continue;
    std::array<VertexId, 4> corners;
    for (std::uint32_t i = 0; i < 4; ++i) {
      const Site s = facets_.corners(f)[i];
      corners[i] = s == kAtInfinity ? kInfinite : vertices[s];
    }
    places[f] = places_in_order(corners);
    for (std::uint32_t i = 0; i < 4; ++i) out.tets[index[f]][places[f][i]] = corners[i];
  }
  for (FacetIndex f = 0; f < facets_.size(); ++f) {
    if (index[f] == kNone) continue;
    for (std::uint32_t i = 0; i < 4; ++i) {
      const Ridge r = facets_.neighbors(f)[i];
      const FacetIndex g = facet_of(r);
      out.neighbors[index[f]][places[f][i]] = 4 * index[g] + places[g][corner_of(r)];
    }
  }
  return out;
}

}  // namespace

LiftedHull lifted_hull(std::span<const Point3> points, const LiftedHullOptions& options) {
  const InsertionOrder order = insertion_order(points.size());
  LargeArray<Point3> sites;
  sites.reserve(points.size());
  for (const VertexId v : order.vertices) sites.push_back(points[+v]);
  const FirstSimplex simplex = first_simplex(sites);
  if (simplex.size < 4) return {};
  Worker worker(sites, std::ldexp(1.0, unit_exponent(sites)));
  worker.run(simplex.corners, options.progress);
  return worker.result(order.vertices);
}

}  // namespace tetsculpt
