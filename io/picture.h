#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "io/image.h"
#include "kernel/point.h"
#include "kernel/triangle_mesh.h"

/// Pictures of surfaces, drawn in software.
namespace tetsculpt {

/// Lines, visible where they lie on the surface.
struct Segments {
  std::vector<std::array<Point3, 2>> ends = {};
  Colour colour = {};
  double width_in_pixels = 1;
};

/// Points as discs, visible where they lie on the surface.
struct Dots {
  std::vector<Point3> centres = {};
  Colour colour = {};
  double radius_in_pixels = 2;
};

struct Scene {
  const TriangleMesh* mesh = nullptr;     ///< may be null; must outlive the drawing
  std::vector<Colour> face_colours = {};  ///< one per triangle, or empty: all in the default colour
  std::vector<Segments> segments = {};
  std::vector<Dots> dots = {};
};

/// The axis that is upright in the picture.
enum class UpAxis { kX, kY, kZ };

/// Where the picture is taken from, looking at the middle of the scene, and its size.
struct View {
  /// In degrees, around the upright axis. From 0 the eye turns from the axis after it towards the
  /// next: with z up, 0 looks from +x and 90 from +y.
  double azimuth = 30;
  double elevation = 20;  ///< in degrees, towards the upright axis
  UpAxis up = UpAxis::kZ;
  std::size_t width = 800;  ///< in pixels, as the height: from 1 to 16384
  std::size_t height = 600;
};

/// Draws the scene in mild perspective, as large as the picture can hold, on white.
///   (1) A triangle is seen from its back (its corners clockwise) in red: where a closed surface is
///       inside out, and into an open one.
///   (2) Any size of coordinates, from the smallest to the largest. What has no extent in the
///       picture, a triangle without area among others, does not show.
///   (3) The same scene and view, the same picture: no threads, no clock.
/// Precondition: coordinates and angles are finite, indices are of points, and sizes as said.
/// Cost: linear in triangles and pixels; 72 bytes per pixel while it draws.
Image draw(const Scene& scene, const View& view = {});

}  // namespace tetsculpt
