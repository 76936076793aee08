// Triangles by edge functions in integers, row by row: each edge bounds the samples of a row.
#include "io/canvas.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tetsculpt {
namespace {

constexpr std::size_t kSamples = 3;  // per pixel, across and down
constexpr std::int64_t kGrid = 256;  // steps between samples to which corners are rounded

struct GridPoint {
  std::int64_t x;
  std::int64_t y;
};

GridPoint on_grid(const CanvasPoint& p) {
  constexpr double kPerPixel = static_cast<double>(kSamples * kGrid);
  return {std::llround(p.x * kPerPixel), std::llround(p.y * kPerPixel)};
}

// Twice the signed area of abc.
std::int64_t area(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::int64_t floor_of(std::int64_t n, std::int64_t divisor) {
  return n >= 0 ? n / divisor : -((-n + divisor - 1) / divisor);
}

// The samples whose middles are from `low` to `high`, of `count`.
struct Range {
  std::int64_t first;
  std::int64_t last;
};

Range samples_between(std::int64_t low, std::int64_t high, std::size_t count) {
  return {std::max<std::int64_t>(0, -floor_of(kGrid / 2 - low, kGrid)),
          std::min(static_cast<std::int64_t>(count) - 1, floor_of(high - kGrid / 2, kGrid))};
}

// The share of a corner in a row's samples: at sample 0, and from one to the next. Negative
// outside.
struct Share {
  std::int64_t start;
  std::int64_t step;
};

Share share(const GridPoint& a, const GridPoint& b, std::int64_t row) {
  return {area(a, b, {kGrid / 2, row * kGrid + kGrid / 2}), (a.y - b.y) * kGrid};
}

void clip(Range& range, const Share& s) {
  if (s.step > 0) {
    range.first = std::max(range.first, -floor_of(s.start, s.step));
  } else if (s.step < 0) {
    range.last = std::min(range.last, floor_of(s.start, -s.step));
  } else if (s.start < 0) {
    range.last = range.first - 1;
  }
}

std::uint8_t channel(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

}  // namespace

Canvas::Canvas(std::size_t width, std::size_t height)
    : width_(width),
      height_(height),
      columns_(kSamples * width),
      rows_(kSamples * height),
      samples_(columns_ * rows_) {}

void Canvas::put(std::size_t column, std::size_t row, double nearness, Colour colour) {
  Sample& sample = samples_[row * columns_ + column];
  if (static_cast<float>(nearness) > sample.nearness) {
    sample = {static_cast<float>(nearness), colour};
  }
}

void Canvas::triangle(const std::array<CanvasPoint, 3>& corners,
                      const std::array<Light, 3>& lights) {
  const std::array<GridPoint, 3> p = {on_grid(corners[0]), on_grid(corners[1]),
                                      on_grid(corners[2])};
  const std::int64_t whole = area(p[0], p[1], p[2]);
  if (whole == 0) return;
  const std::size_t second = whole > 0 ? 1 : 2;  // so that 0, second, third has a positive area
  const std::size_t third = 3 - second;
  const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
  const Range columns = samples_between(left, right, columns_);
  const Range rows = samples_between(top, bottom, rows_);
  for (std::int64_t row = rows.first; row <= rows.last; ++row) {
    const std::array<Share, 3> shares = {share(p[second], p[third], row),
                                         share(p[third], p[0], row), share(p[0], p[second], row)};
    Range range = columns;
    for (const Share& s : shares) clip(range, s);
    const auto mean = [&](std::int64_t column, double of_0, double of_second, double of_third) {
      const auto weight = [&](const Share& s) {
        return static_cast<double>(s.start + column * s.step);
      };
      return (weight(shares[0]) * of_0 + weight(shares[1]) * of_second +
              weight(shares[2]) * of_third) /
             static_cast<double>(std::abs(whole));
    };
    for (std::int64_t column = range.first; column <= range.last; ++column) {
      const auto light = [&](std::size_t i) {
        return channel(mean(column, lights[0][i], lights[second][i], lights[third][i]));
      };
      put(static_cast<std::size_t>(column), static_cast<std::size_t>(row),
          mean(column, corners[0].nearness, corners[second].nearness, corners[third].nearness),
          {light(0), light(1), light(2)});
    }
  }
}

void Canvas::capsule(const CanvasPoint& a, const CanvasPoint& b, double radius, Colour colour) {
  constexpr double kPerPixel = kSamples;
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double squared_length = dx * dx + dy * dy;
  const auto sample_at = [&](double pixel, std::size_t count) {
    const double place = std::clamp(pixel * kPerPixel, 0.0, static_cast<double>(count));
    return static_cast<std::size_t>(place);
  };
  const std::size_t end = std::min(rows_, sample_at(std::max(a.y, b.y) + radius, rows_) + 1);
  for (std::size_t row = sample_at(std::min(a.y, b.y) - radius, rows_); row < end; ++row) {
    const double y = (static_cast<double>(row) + 0.5) / kPerPixel;
    // The part of the segment that is near enough in y alone bounds the columns.
    double from = 0;
    double to = 1;
    if (dy != 0) {
      const auto [low, high] = std::minmax({(y - radius - a.y) / dy, (y + radius - a.y) / dy});
      from = std::clamp(low, 0.0, 1.0);
      to = std::clamp(high, 0.0, 1.0);
    }
    const auto [left, right] = std::minmax({a.x + from * dx, a.x + to * dx});
    const std::size_t columns_end = std::min(columns_, sample_at(right + radius, columns_) + 1);
    for (std::size_t column = sample_at(left - radius, columns_); column < columns_end; ++column) {
      const double x = (static_cast<double>(column) + 0.5) / kPerPixel;
      const double along = (x - a.x) * dx + (y - a.y) * dy;
      const double t = squared_length > 0 ? std::clamp(along / squared_length, 0.0, 1.0) : 0.0;
      const double off_x = x - (a.x + t * dx);
      const double off_y = y - (a.y + t * dy);
      if (off_x * off_x + off_y * off_y > radius * radius) continue;
      put(column, row, a.nearness + t * (b.nearness - a.nearness), colour);
    }
  }
}

Image Canvas::image() const {
  Image result{width_, height_, {}};
  result.rgb.reserve(3 * width_ * height_);
  constexpr unsigned kCount = kSamples * kSamples;
  for (std::size_t y = 0; y < height_; ++y) {
    for (std::size_t x = 0; x < width_; ++x) {
      std::array<unsigned, 3> sum{};
      for (std::size_t i = 0; i < kCount; ++i) {
        const std::size_t row = kSamples * y + i / kSamples;
        const Colour& c = samples_[row * columns_ + kSamples * x + i % kSamples].colour;
        sum[0] += c.r;
        sum[1] += c.g;
        sum[2] += c.b;
      }
      for (const unsigned s : sum) {
        result.rgb.push_back(static_cast<std::uint8_t>((s + kCount / 2) / kCount));
      }
    }
  }
  return result;
}

}  // namespace tetsculpt
