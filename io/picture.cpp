// A z-buffer: turn the scene, fit it into the picture, light the corners, fill.
#include "io/picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "io/camera.h"
#include "io/canvas.h"
#include "io/corner_normals.h"
#include "kernel/vec3.h"

namespace tetsculpt {
namespace {

constexpr Colour kSurface = {186, 200, 222};
constexpr Colour kBack = {214, 62, 48};
// Backs give way where they and fronts meet at a silhouette; in pixels.
constexpr double kBackRecedes = 0.5;
constexpr double kMarksAdvance = 3;

// The eye carries a light; another one is at its upper left.
constexpr double kAmbient = 0.25;
constexpr double kHeadlight = 0.45;
constexpr double kFixedLight = 0.4;
constexpr Vec3<double> kFixedDirection = {-0.48, 0.64, 0.6};

template <class Visit>
void for_each_point(const Scene& scene, const Visit& visit) {
  if (scene.mesh != nullptr) {
    for (const auto& triangle : scene.mesh->triangles) {
      for (const std::uint32_t p : triangle) visit(scene.mesh->points[p]);
    }
  }
  for (const Segments& segments : scene.segments) {
    for (const auto& [a, b] : segments.ends) {
      visit(a);
      visit(b);
    }
  }
  for (const Dots& dots : scene.dots) std::ranges::for_each(dots.centres, visit);
}

// `normal` points to the eye's side.
Light lit(Colour colour, const Vec3<double>& normal) {
  const double light = kAmbient + kHeadlight * std::max(0.0, normal.z) +
                       kFixedLight * std::max(0.0, dot(normal, kFixedDirection));
  const auto channel = [&](std::uint8_t c) {
    return static_cast<float>(std::min(255.0, light * c));
  };
  return {channel(colour.r), channel(colour.g), channel(colour.b)};
}

Colour seen_from_back(Colour colour) {
  const auto mixed = [](std::uint8_t own, std::uint8_t back) {
    return static_cast<std::uint8_t>((own + 3 * back) / 4);
  };
  return {mixed(colour.r, kBack.r), mixed(colour.g, kBack.g), mixed(colour.b, kBack.b)};
}

// In the picture y goes down: counterclockwise is negative.
bool faces_the_eye(const std::array<CanvasPoint, 3>& p) {
  return (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x) <= 0;
}

void draw_mesh(const Scene& scene, const Turn& turn, const Lens& lens, Canvas& canvas) {
  const TriangleMesh& mesh = *scene.mesh;
  assert(scene.face_colours.empty() || scene.face_colours.size() == mesh.triangles.size());
  std::vector<Vec3<double>> points;
  points.reserve(mesh.points.size());
  for (const Point3& p : mesh.points) points.push_back(turn(p));
  const auto normals = corner_normals(points, mesh.triangles);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    std::array<CanvasPoint, 3> corners = {lens.place(points[a]), lens.place(points[b]),
                                          lens.place(points[c])};
    Colour colour = scene.face_colours.empty() ? kSurface : scene.face_colours[t];
    const bool front = faces_the_eye(corners);
    if (!front) {
      colour = seen_from_back(colour);
      corners = {lens.place(points[a], -kBackRecedes), lens.place(points[b], -kBackRecedes),
                 lens.place(points[c], -kBackRecedes)};
    }
    std::array<Light, 3> lights;
    for (std::size_t i = 0; i < 3; ++i)
      lights[i] = lit(colour, normals[t][i] * (front ? 1.0 : -1.0));
    canvas.triangle(corners, lights);
  }
}

// Marks come forward by some of their radii, so that they lie on a surface up to that slope.
void draw_marks(const Scene& scene, const Turn& turn, const Lens& lens, Canvas& canvas) {
  for (const Segments& segments : scene.segments) {
    const double radius = segments.width_in_pixels / 2;
    for (const auto& [a, b] : segments.ends) {
      canvas.capsule(lens.place(turn(a), kMarksAdvance * radius),
                     lens.place(turn(b), kMarksAdvance * radius), radius, segments.colour);
    }
  }
  for (const Dots& dots : scene.dots) {
    const double radius = dots.radius_in_pixels;
    for (const Point3& p : dots.centres) {
      const CanvasPoint at = lens.place(turn(p), kMarksAdvance * radius);
      canvas.capsule(at, at, radius, dots.colour);
    }
  }
}

}  // namespace

Image draw(const Scene& scene, const View& view) {
  assert(std::isfinite(view.azimuth) && std::isfinite(view.elevation));
  Canvas canvas(view.width, view.height);
  Box box;
  for_each_point(scene, [&](const Point3& p) { box.include(p); });
  if (box.empty) return canvas.image();
  const Turn turn(box, view);
  Lens lens;
  for_each_point(scene, [&](const Point3& p) { lens.include(turn(p)); });
  lens.fit(view.width, view.height);
  if (scene.mesh != nullptr) draw_mesh(scene, turn, lens, canvas);
  draw_marks(scene, turn, lens, canvas);
  return canvas.image();
}

}  // namespace tetsculpt
