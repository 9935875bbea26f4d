// Cameras: from world coordinates to pixels, for worlds in the plane and in space.
#pragma once

#include "base/vec.h"
#include "sturnus/picture.h"

namespace sturnus {

/// Where a picture is seen from, in world terms; the size of the picture comes later.
struct Viewpoint {
  bool in_space = false;  ///< perspective view of a world in space, or flat view of the plane

  Vec<3> low{{0, 0, 0}};   ///< flat: corner of the rectangle to be seen, world
  Vec<3> high{{1, 1, 0}};  ///< flat: the opposite corner, world
  float margin = 16;       ///< flat: kept free around the rectangle, pixels

  Vec<3> eye{{0, 0, 1}};     ///< space: where the viewer stands, world
  Vec<3> target{{0, 0, 0}};  ///< space: what is in the middle of the picture, world
  Vec<3> up{{0, 1, 0}};      ///< space: what points up in the picture, any length
  float field_of_view = 40;  ///< space: full vertical angle, degrees, between 0 and 180
  float fade_from = 0;       ///< space: distance along the view where fading begins, world
  float fade_to = 0;  ///< space: distance where it is complete, world; no fading unless above fade_from
};

/// The rectangle from low to high, as large as fits with a margin in pixels; y points up.
Viewpoint flat_view(const Vec<3>& low, const Vec<3>& high, float margin = 16);

/// A perspective view without fading. An `up` along the view is replaced by an axis that is not.
Viewpoint look_at(const Vec<3>& eye, const Vec<3>& target, const Vec<3>& up, float field_of_view = 40);

/// A view of the whole box from the side that `towards_eye` points to, as near as all corners allow.
/// `aspect` is the picture's width over its height; fading runs through the box.
Viewpoint fit_box(const Vec<3>& low, const Vec<3>& high, const Vec<3>& towards_eye, const Vec<3>& up,
                  float aspect, float field_of_view = 40);

/// The same from above the right front corner, with y up.
Viewpoint three_quarter_view(const Vec<3>& low, const Vec<3>& high, float aspect, float field_of_view = 32);

Vec<3> cross(const Vec<3>& a, const Vec<3>& b);

/// A right-handed basis with w along a vector.
struct Basis {
  Vec<3> u, v, w;
};

/// The basis with w = unit(along), by the method of Shirley and Marschner, 2.4.6. `along` must not be zero.
Basis basis_along(const Vec<3>& along);

/// A place in the picture.
struct Projected {
  float x = 0;      ///< pixels from the left edge
  float y = 0;      ///< pixels from the top edge
  float depth = 0;  ///< distance along the view, world; 0 in flat pictures
  float scale = 0;  ///< pixels for one world length there
  bool in_front =
      false;  ///< false behind the viewer or where a coordinate is no number; then nothing else holds
};

/// A viewpoint made ready for one size of picture.
class Projection {
 public:
  Projection(const Viewpoint& viewpoint, Size size);

  Projected project(const Vec<3>& point) const;

  /// Moves the ends of a line in front of the viewer; false when no part of it is there.
  bool clip(Vec<3>& from, Vec<3>& to) const;

  /// How far the colour at this depth fades to the background, 0 to 1.
  float fade(float depth) const;

  bool in_space() const { return viewpoint_.in_space; }
  const Vec<3>& eye() const { return viewpoint_.eye; }
  const Vec<3>& right() const { return right_; }
  const Vec<3>& up() const { return up_; }
  const Vec<3>& forward() const { return forward_; }
  /// Space: pixels for a step aside as long as the depth.
  float pixels_per_slope() const { return scale_; }
  /// Space: depth at which lines and triangles are cut off, world.
  float nearest() const { return near_; }

 private:
  float depth_of(const Vec<3>& point) const { return dot(point - viewpoint_.eye, forward_); }

  Viewpoint viewpoint_;
  Vec<3> right_{{1, 0, 0}};
  Vec<3> up_{{0, 1, 0}};
  Vec<3> forward_{{0, 0, -1}};
  float scale_ = 1;  // flat: pixels per world length; space: pixels per unit of slope
  float centre_x_ = 0;
  float centre_y_ = 0;
  Vec<3> middle_;  // flat: what stands in the middle of the picture
  float near_ = 0;
};

}  // namespace sturnus
