#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/image.h"

namespace tetsculpt {

/// A place in the picture. x and y in pixels, to the right and down from the upper left corner.
struct CanvasPoint {
  double x = 0;
  double y = 0;
  /// Linear in the picture, and the greater the nearer; what is drawn has more than 0.
  double nearness = 0;
};

/// From 0 to 255 per channel.
using Light = std::array<float, 3>;

/// A white picture to draw on, with several samples per pixel and the nearest thing at each.
///   (1) Triangles that share an edge leave no gap: corners are rounded to a fine grid, and whether
///       a sample is inside is decided in integers, edges included.
///   (2) Of equally near things the first stays.
class Canvas {
 public:
  /// Precondition: width and height are at most 16384.
  Canvas(std::size_t width, std::size_t height);

  /// Colours go from corner to corner linearly. Either orientation; without area, nothing.
  void triangle(const std::array<CanvasPoint, 3>& corners, const std::array<Light, 3>& lights);
  /// All that is within `radius` (pixels) of the segment ab, which may be one point.
  void capsule(const CanvasPoint& a, const CanvasPoint& b, double radius, Colour colour);
  /// The picture: each pixel the mean of its samples.
  Image image() const;

 private:
  struct Sample {
    float nearness = 0;
    Colour colour = {255, 255, 255};
  };
  void put(std::size_t column, std::size_t row, double nearness, Colour colour);

  std::size_t width_;
  std::size_t height_;
  std::size_t columns_;  // of samples
  std::size_t rows_;
  std::vector<Sample> samples_;
};

}  // namespace tetsculpt
