// A k-d tree without nodes: a range of points is split at its middle along its widest axis, so that
// the tree is an order of the points. [Bentley 1975]
#include "kernel/nearest_distances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>

namespace tetsculpt {
namespace {

using Coordinates = std::array<double, 3>;

double squared_distance(const Coordinates& a, const Coordinates& b) {
  const double x = a[0] - b[0];
  const double y = a[1] - b[1];
  const double z = a[2] - b[2];
  return x * x + y * y + z * z;
}

class Tree {
 public:
  explicit Tree(std::span<const Point3> points) {
    for (const Point3& p : points) places_.push_back({p.x, p.y, p.z});
    order_.resize(places_.size());
    std::iota(order_.begin(), order_.end(), 0u);
    axis_.resize(places_.size());
    build(0, order_.size());
  }

  double nearest(std::uint32_t from) const {
    Search search{from, std::numeric_limits<double>::infinity()};
    visit(0, order_.size(), search);
    return std::sqrt(search.best);
  }

 private:
  static constexpr std::size_t kLeaf = 8;
  struct Search {
    std::uint32_t from;
    double best;
  };

  void build(std::size_t begin, std::size_t end) {
    if (end - begin <= kLeaf) return;
    const std::size_t middle = begin + (end - begin) / 2;
    const std::size_t axis = widest_axis(begin, end);
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
      return places_[a][axis] < places_[b][axis];
    });
    axis_[middle] = static_cast<std::uint8_t>(axis);
    build(begin, middle);
    build(middle + 1, end);
  }

  std::size_t widest_axis(std::size_t begin, std::size_t end) const {
    Coordinates low = places_[order_[begin]];
    Coordinates high = low;
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], places_[order_[i]][k]);
        high[k] = std::max(high[k], places_[order_[i]][k]);
      }
    }
    std::size_t widest = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (high[k] - low[k] > high[widest] - low[widest]) widest = k;
    }
    return widest;
  }

  void look_at(std::size_t i, Search& search) const {
    if (order_[i] == search.from) return;
    search.best = std::min(search.best, squared_distance(places_[order_[i]], places_[search.from]));
  }

  void visit(std::size_t begin, std::size_t end, Search& search) const {
    if (end - begin <= kLeaf) {
      for (std::size_t i = begin; i < end; ++i) look_at(i, search);
      return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const std::size_t axis = axis_[middle];
    const double to_plane = places_[search.from][axis] - places_[order_[middle]][axis];
    look_at(middle, search);
    if (to_plane < 0) {
      visit(begin, middle, search);
      if (to_plane * to_plane <= search.best) visit(middle + 1, end, search);
    } else {
      visit(middle + 1, end, search);
      if (to_plane * to_plane <= search.best) visit(begin, middle, search);
    }
  }

  std::vector<Coordinates> places_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint8_t> axis_;  // of the split at that place
};

}  // namespace

std::vector<double> nearest_distances(std::span<const Point3> points) {
  const Tree tree(points);
  std::vector<double> distances(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) distances[i] = tree.nearest(i);
  return distances;
}

}  // namespace tetsculpt
