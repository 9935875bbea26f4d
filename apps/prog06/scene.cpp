// Lines around the boids, and the camera in front of them.
#include "scene.h"

#include <sturnus/scenario.h>

#include <algorithm>
#include <cmath>

namespace prog06 {
namespace {

using sturnus::Line3;
using sturnus::Point3;

constexpr sturnus::Rgba edge_colour = sturnus::rgb(0x2f3b46);
constexpr sturnus::Rgba attract_colour = sturnus::rgb(0x56b4e9);
constexpr sturnus::Rgba repel_colour = sturnus::rgb(0xd55e00);

float dot(const Point3& a, const Point3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Point3 minus(const Point3& a, const Point3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

sturnus::SpaceCamera camera_of(const Choices& choices) {
  sturnus::SpaceCamera camera;
  camera.eye = eye_of(choices);
  camera.target = choices.target;
  camera.field_of_view = static_cast<float>(choices.field_of_view);
  if (choices.dimensions == 2) return camera;
  // Distance shows as haze, over the depth of the cube.
  const Point3 view = minus(camera.target, camera.eye);
  const float distance = std::sqrt(dot(view, view));
  camera.fade_from = std::max(0.0f, distance - 0.4f);
  camera.fade_to = distance + 1.4f;
  return camera;
}

// The corner of the box that the bits of `index` choose; flat boxes have no depth.
Point3 corner(const sturnus::Extent& box, unsigned index) {
  Point3 out{};
  for (std::size_t axis = 0; axis < box.min.size(); ++axis) {
    out[axis] = static_cast<float>((index >> axis & 1u) != 0 ? box.max[axis] : box.min[axis]);
  }
  return out;
}

// The edges run between corners that differ in one axis.
void add_box(const sturnus::Extent& box, std::vector<Line3>& lines) {
  const auto dimensions = static_cast<unsigned>(box.min.size());
  for (unsigned index = 0; index < 1u << dimensions; ++index) {
    for (unsigned axis = 0; axis < dimensions; ++axis) {
      const unsigned other = index | 1u << axis;
      if (other != index) lines.push_back({corner(box, index), corner(box, other), edge_colour, 1.5f});
    }
  }
}

// A cross where the mouse holds the boids.
void add_pointer(const sturnus::PointerState& pointer, std::vector<Line3>& lines) {
  if (!pointer.pressed) return;
  constexpr float arm = 0.03f;
  const sturnus::Rgba colour = pointer.mode == sturnus::PointerMode::attract ? attract_colour : repel_colour;
  const auto [x, y, z] = pointer.at;
  lines.push_back({{x - arm, y, z}, {x + arm, y, z}, colour, 2});
  lines.push_back({{x, y - arm, z}, {x, y + arm, z}, colour, 2});
}

}  // namespace

Scene::Scene(const Choices& choices)
    : camera_(camera_of(choices)),
      options_{choices.size, sturnus::ThemeName::dark, 0},
      is_flat_(choices.dimensions == 2),
      cones_(static_cast<float>(choices.boid_size)) {}

sturnus::Image Scene::picture(const sturnus::View& view) const {
  std::vector<Line3> lines;
  add_box(sturnus::extent_of(view.scenario()), lines);
  add_pointer(view.state().pointer, lines);
  return sturnus::draw_triangles(cones_.triangles(view), lines, camera_, options_);
}

std::optional<Point3> Scene::place_under(int x, int y) const {
  const Point3 along = sturnus::direction_through(camera_, options_.size, static_cast<float>(x) + 0.5f,
                                                  static_cast<float>(y) + 0.5f);
  const Point3 normal = is_flat_ ? Point3{0, 0, 1} : minus(camera_.target, camera_.eye);
  const Point3 through = is_flat_ ? Point3{} : camera_.target;
  const float steps = dot(minus(through, camera_.eye), normal) / dot(along, normal);
  if (!(steps > 0) || !(steps < 1e6f)) return {};
  return Point3{camera_.eye[0] + along[0] * steps, camera_.eye[1] + along[1] * steps,
                is_flat_ ? 0.0f : camera_.eye[2] + along[2] * steps};
}

}  // namespace prog06
