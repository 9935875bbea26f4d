// Triangles in space, drawn with flat shading: for programs that make their own geometry.
#pragma once

#include <sturnus/picture.h>

#include <array>
#include <optional>
#include <vector>

namespace sturnus {

/// A place or a direction in space: x, y, z, in the caller's unit of length.
using Point3 = std::array<float, 3>;

/// A flat triangle. Both of its sides are seen, and the one that faces the viewer is lit.
struct Triangle {
  std::array<Point3, 3> corners;  ///< length; the order does not matter
  Rgba colour;                    ///< in full light; faces turned away from the light are half as bright
};

/// A straight line that triangles may hide.
struct Line3 {
  Point3 from{};       ///< length
  Point3 to{};         ///< length
  Rgba colour;         ///< its opacity counts
  float width = 1.5f;  ///< pixels, the same at every distance
};

/// Where a picture is taken from. The light comes from above the viewer's left shoulder.
struct SpaceCamera {
  Point3 eye{0, 0, 2};       ///< length; where the viewer stands, not on the target
  Point3 target{};           ///< length; what is in the middle of the picture
  Point3 up{0, 1, 0};        ///< what points up in the picture, any length
  float field_of_view = 35;  ///< degrees, the full vertical angle, 1 to 170
  float fade_from = 0;       ///< length; the distance at which colours begin to sink into the background
  float fade_to = 0;         ///< length; where they have; no fading unless this is above fade_from
};

/// Draws triangles that hide one another, then the lines. A corner that is no finite number leaves its
/// triangle or line out; what reaches behind the viewer is cut off. `threads` 0: one for each core; the
/// picture does not depend on it.
Image draw_triangles(const std::vector<Triangle>& triangles, const std::vector<Line3>& lines,
                     const SpaceCamera& camera, const PictureOptions& options = {}, int threads = 0);

/// The direction, of unit depth along the view, from the camera's eye through a place in the picture. `x` in
/// pixels from the left edge, `y` from the top; a pixel's middle is at a half.
Point3 direction_through(const SpaceCamera& camera, Size size, float x, float y);

/// A right-handed set of unit vectors that are at right angles.
struct Frame3 {
  Point3 u{1, 0, 0};
  Point3 v{0, 1, 0};
  Point3 w{0, 0, 1};
};

/// The frame whose w points along a direction of any length, by the method of Shirley and Marschner, 2.4.6:
/// from a single vector. Nothing where there is no direction: zero, or a component that is no finite number.
std::optional<Frame3> frame_along(const Point3& direction);

}  // namespace sturnus
