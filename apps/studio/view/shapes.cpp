// Shapes as triangles: a core in full colour, and beside it a pixel that fades, so that edges are soft.
#include "view/shapes.h"

#include <algorithm>

namespace studio {
namespace {

constexpr int steps_of_a_turn = 64;
constexpr float full_turn = 6.283185307f;

sturnus::Rgba clear(sturnus::Rgba colour) {
  colour.a = 0;
  return colour;
}

}  // namespace

void Shapes::triangle(const Point& a, const Point& b, const Point& c, sturnus::Rgba colour) {
  triangles_.insert(triangles_.end(), {{a, colour}, {b, colour}, {c, colour}});
}

// From one edge in full colour to one that is clear.
void Shapes::fringe(const Point& a, const Point& b, const Point& a_out, const Point& b_out,
                    sturnus::Rgba colour) {
  const sturnus::Rgba none = clear(colour);
  triangles_.insert(triangles_.end(),
                    {{a, colour}, {b, colour}, {b_out, none}, {a, colour}, {b_out, none}, {a_out, none}});
}

Point Shapes::aside(const Point& at, const Point& along) const {
  const Point towards = camera_->dimensions() == 2 ? camera_->forward() : unit(at - camera_->eye());
  return unit(cross(along, towards), camera_->right());
}

void Shapes::line(const Point& from, const Point& to, sturnus::Rgba colour, float width) {
  const Point side_from = aside(from, to - from);
  const Point side_to = aside(to, to - from);
  const float half = std::max(0.0f, 0.5f * (width * scale_ - 1));
  const float at_from = camera_->pixel_length(from);
  const float at_to = camera_->pixel_length(to);
  const Point a = from - side_from * (half * at_from);
  const Point b = from + side_from * (half * at_from);
  const Point c = to + side_to * (half * at_to);
  const Point d = to - side_to * (half * at_to);
  if (half > 0) {
    triangle(a, b, c, colour);
    triangle(a, c, d, colour);
  }
  fringe(a, d, a - side_from * at_from, d - side_to * at_to, colour);
  fringe(b, c, b + side_from * at_from, c + side_to * at_to, colour);
}

void Shapes::arrow(const Point& from, const Point& to, sturnus::Rgba colour, float width) {
  const float whole = length(to - from);
  if (!(whole > 0)) return;
  const Point along = unit(to - from);
  // A short arrow shrinks its head before it loses it.
  const float head = std::min(4.5f * width * scale_ * camera_->pixel_length(to), whole);
  const Point side = aside(to, along) * (0.45f * head);
  const Point neck = to - along * (0.8f * head);
  const Point left = to - along * head + side;
  const Point right = to - along * head - side;
  if (whole > head) line(from, neck, colour, width);
  triangle(to, left, neck, colour);
  triangle(to, neck, right, colour);
  const float pixel = camera_->pixel_length(to);
  const Point out = unit(side) * pixel;
  const Point tip = to + along * (2 * pixel);
  fringe(to, left, tip, left + out, colour);
  fringe(to, right, tip, right - out, colour);
}

Point Shapes::on_circle(const Point& centre, float radius, float turn) const {
  return centre + (camera_->right() * std::cos(turn) + camera_->up() * std::sin(turn)) * radius;
}

void Shapes::ring(const Point& centre, float radius, sturnus::Rgba colour, float width) {
  if (!std::isfinite(radius)) return;
  const float pixel = camera_->pixel_length(centre);
  const float half = std::max(0.0f, 0.5f * (width * scale_ - 1)) * pixel;
  for (int i = 0; i < steps_of_a_turn; ++i) {
    const float from = full_turn * static_cast<float>(i) / steps_of_a_turn;
    const float to = full_turn * static_cast<float>(i + 1) / steps_of_a_turn;
    const auto at = [&](float turn, float out) {
      return on_circle(centre, std::max(0.0f, radius + out), turn);
    };
    if (half > 0) {
      triangle(at(from, -half), at(from, half), at(to, half), colour);
      triangle(at(from, -half), at(to, half), at(to, -half), colour);
    }
    fringe(at(from, half), at(to, half), at(from, half + pixel), at(to, half + pixel), colour);
    fringe(at(from, -half), at(to, -half), at(from, -half - pixel), at(to, -half - pixel), colour);
  }
}

void Shapes::disc(const Point& centre, float radius, sturnus::Rgba colour) {
  if (!std::isfinite(radius)) return;
  const float pixel = camera_->pixel_length(centre);
  for (int i = 0; i < steps_of_a_turn; ++i) {
    const float from = full_turn * static_cast<float>(i) / steps_of_a_turn;
    const float to = full_turn * static_cast<float>(i + 1) / steps_of_a_turn;
    const Point a = on_circle(centre, radius, from);
    const Point b = on_circle(centre, radius, to);
    triangle(centre, a, b, colour);
    fringe(a, b, on_circle(centre, radius + pixel, from), on_circle(centre, radius + pixel, to), colour);
  }
}

void Shapes::sector(const Point& centre, const Point& heading, float radius, float angle,
                    sturnus::Rgba colour) {
  if (!std::isfinite(radius)) return;
  const float across = dot(heading, camera_->right());
  const float upwards = dot(heading, camera_->up());
  const float middle = std::atan2(upwards, across);
  const float whole = full_turn * std::clamp(angle, 0.0f, 360.0f) / 360;
  for (int i = 0; i < steps_of_a_turn; ++i) {
    const float from = middle + whole * (static_cast<float>(i) / steps_of_a_turn - 0.5f);
    const float to = middle + whole * (static_cast<float>(i + 1) / steps_of_a_turn - 0.5f);
    triangle(centre, on_circle(centre, radius, from), on_circle(centre, radius, to), colour);
  }
}

void Shapes::box(const Point& low, const Point& high, sturnus::Rgba colour, float width) {
  const std::size_t dimensions = camera_->dimensions() == 2 ? 2 : 3;
  const Point size = high - low;
  for (std::size_t axis = 0; axis < dimensions; ++axis) {
    const std::size_t second = (axis + 1) % dimensions;
    const std::size_t third = (axis + 2) % dimensions;
    for (int side = 0; side < (dimensions == 2 ? 2 : 4); ++side) {
      Point from = low;
      if ((side & 1) != 0) from[second] = high[second];
      if ((side & 2) != 0) from[third] = high[third];
      Point to = from;
      to[axis] += size[axis];
      line(from, to, colour, width);
    }
  }
}

}  // namespace studio
