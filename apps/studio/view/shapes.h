// Lines, rings, discs and arrows in the world, gathered for one draw: what tools and panels add to the view.
#pragma once

#include <sturnus/colour.h>

#include <array>
#include <vector>

#include "view/camera.h"

namespace studio {

/// A corner of a triangle that is already as wide as it shall be on the screen.
struct ShapeCorner {
  Point position{};
  sturnus::Rgba colour;
};

/// Widths are pixels (times the display's scale), all else world lengths. Things lie above the boids.
class Shapes {
 public:
  /// Everything from here on is seen by this camera.
  Shapes(const Camera& camera, float scale) : camera_(&camera), scale_(scale) {}

  void line(const Point& from, const Point& to, sturnus::Rgba colour, float width = 1.5f);
  /// A line with a head at its end.
  void arrow(const Point& from, const Point& to, sturnus::Rgba colour, float width = 2);
  /// A circle in the plane, or facing the camera.
  void ring(const Point& centre, float radius, sturnus::Rgba colour, float width = 1.5f);
  void disc(const Point& centre, float radius, sturnus::Rgba colour);
  /// The part of a disc within half of `angle` (degrees) on both sides of a heading.
  void sector(const Point& centre, const Point& heading, float radius, float angle, sturnus::Rgba colour);
  /// The edges of a box; in the plane a rectangle.
  void box(const Point& low, const Point& high, sturnus::Rgba colour, float width = 1.5f);

  const std::vector<ShapeCorner>& triangles() const { return triangles_; }

 private:
  void triangle(const Point& a, const Point& b, const Point& c, sturnus::Rgba colour);
  void fringe(const Point& a, const Point& b, const Point& a_out, const Point& b_out, sturnus::Rgba colour);
  Point aside(const Point& at, const Point& along) const;
  Point on_circle(const Point& centre, float radius, float turn) const;

  const Camera* camera_;
  float scale_ = 1;
  std::vector<ShapeCorner> triangles_;
};

}  // namespace studio
