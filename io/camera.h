#pragma once

#include <cstddef>

#include "io/canvas.h"
#include "io/picture.h"
#include "kernel/box.h"
#include "kernel/point.h"
#include "kernel/vec3.h"

/// From the scene's coordinates to the picture's, in two steps.
namespace tetsculpt {

/// Turns the scene so that it is seen along -z, and brings it into the unit ball around 0.
class Turn {
 public:
  /// `box` of all points of the scene; not empty.
  Turn(const Box& box, const View& view);
  /// x to the right, y up, z towards the eye.
  Vec3<double> operator()(const Point3& p) const;

 private:
  Vec3<double> scaled(const Point3& p) const;

  int exponent_;  // of the largest coordinate: nothing overflows once it is taken off
  Vec3<double> middle_;
  double radius_;
  Vec3<double> right_;
  Vec3<double> up_;
  Vec3<double> to_eye_;
};

/// The perspective of an eye at z = 4, and the place of its image in the picture. Use: include()
/// all points of the scene, fit(), then place().
class Lens {
 public:
  void include(const Vec3<double>& p);
  void fit(std::size_t width, std::size_t height);
  /// `towards_eye`: how many pixels the point is to come nearer than it is.
  CanvasPoint place(const Vec3<double>& p, double towards_eye = 0) const;

 private:
  Box seen_;
  double pixels_ = 1;  // per unit at distance 1 from the eye
  double x_ = 0;       // the pixel that is straight ahead
  double y_ = 0;
};

}  // namespace tetsculpt
