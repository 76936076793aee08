#include "io/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tetsculpt {
namespace {

constexpr double kEye = 4;        // distance from the middle, in radii of the scene
constexpr double kMargin = 0.04;  // of the picture's smaller side, on each side
constexpr double kNearest = 0.5;  // nothing comes nearer to the eye than by this share

double largest(const Point3& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

// The axes, of which z is upright, as those of the scene: (x, y, z) is a cyclic shift of them.
Vec3<double> along_axes(const Vec3<double>& v, UpAxis up) {
  switch (up) {
    case UpAxis::kX:
      return {v.z, v.x, v.y};
    case UpAxis::kY:
      return {v.y, v.z, v.x};
    default:
      return v;
  }
}

Vec3<double> minus(const Vec3<double>& a, const Vec3<double>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

}  // namespace

Turn::Turn(const Box& box, const View& view) {
  const double extreme = std::max(largest(box.low), largest(box.high));
  exponent_ = extreme > 0 ? std::ilogb(extreme) : 0;
  const Vec3<double> low = scaled(box.low);
  const Vec3<double> high = scaled(box.high);
  middle_ = (low + high) * 0.5;
  const Vec3<double> half = minus(high, low) * 0.5;
  radius_ = std::hypot(half.x, half.y, half.z);
  if (radius_ == 0) radius_ = 1;

  // Multiples of right angles are to give exact axes: a full turn of rounding errors shows.
  const auto cosine = [](double degrees) {
    const double turn = std::remainder(degrees, 360.0);
    return std::abs(turn) == 90 ? 0.0 : std::cos(turn * (std::numbers::pi / 180));
  };
  const double cos_a = cosine(view.azimuth);
  const double sin_a = cosine(view.azimuth - 90);
  const double cos_e = cosine(view.elevation);
  const double sin_e = cosine(view.elevation - 90);
  right_ = along_axes({-sin_a, cos_a, 0}, view.up);
  up_ = along_axes({-cos_a * sin_e, -sin_a * sin_e, cos_e}, view.up);
  to_eye_ = along_axes({cos_a * cos_e, sin_a * cos_e, sin_e}, view.up);
}

Vec3<double> Turn::scaled(const Point3& p) const {
  return {std::scalbn(p.x, -exponent_), std::scalbn(p.y, -exponent_), std::scalbn(p.z, -exponent_)};
}

Vec3<double> Turn::operator()(const Point3& p) const {
  const Vec3<double> v = minus(scaled(p), middle_) * (1 / radius_);
  return {dot(v, right_), dot(v, up_), dot(v, to_eye_)};
}

void Lens::include(const Vec3<double>& p) {
  seen_.include({p.x / (kEye - p.z), p.y / (kEye - p.z), 0});
}

void Lens::fit(std::size_t width, std::size_t height) {
  const auto w = static_cast<double>(width);
  const auto h = static_cast<double>(height);
  const double margin = kMargin * std::min(w, h);
  const double extent_x = seen_.high.x - seen_.low.x;
  const double extent_y = seen_.high.y - seen_.low.y;
  pixels_ = kEye * std::min(w, h);  // for what is a point in the picture
  if (extent_x > 0 || extent_y > 0) {
    const double of_x = (w - 2 * margin) / extent_x;
    const double of_y = (h - 2 * margin) / extent_y;
    pixels_ = std::min({of_x, of_y, 1e6 * pixels_});
  }
  x_ = w / 2 - pixels_ * (seen_.low.x + seen_.high.x) / 2;
  y_ = h / 2 + pixels_ * (seen_.low.y + seen_.high.y) / 2;
}

CanvasPoint Lens::place(const Vec3<double>& p, double towards_eye) const {
  const double nearness = 1 / (kEye - p.z);
  const double share = std::min(towards_eye / pixels_, kNearest);
  return {x_ + pixels_ * p.x * nearness, y_ - pixels_ * p.y * nearness, nearness / (1 - share)};
}

}  // namespace tetsculpt
