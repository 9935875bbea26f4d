// Projection of the plane and of space, and views that fit a box.
#include "draw/camera.h"

#include <algorithm>
#include <cmath>

namespace sturnus {
namespace {

constexpr float degree = 0.017453292519943295f;
constexpr float free_border = 0.06f;  // part of half the picture that a fitted box leaves free

float half_slope(float field_of_view) {
  return std::tan(std::clamp(field_of_view, 1.0f, 170.0f) * 0.5f * degree);
}

bool is_finite(const Vec<3>& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

int smallest_axis(const Vec<3>& v) {
  int axis = 0;
  for (int other = 1; other < 3; ++other) {
    if (std::abs(v[other]) < std::abs(v[axis])) axis = other;
  }
  return axis;
}

// The picture's right and up for a view along `forward`.
Basis view_axes(const Vec<3>& forward, const Vec<3>& up) {
  Vec<3> right = cross(forward, unit(up));
  if (dot(right, right) < 1e-10f) {
    const Basis any = basis_along(forward);
    right = any.u;
  }
  right = unit(right);
  return {right, cross(right, forward), forward};
}

Vec<3> corner(const Vec<3>& low, const Vec<3>& high, int index) {
  return {{(index & 1) != 0 ? high[0] : low[0], (index & 2) != 0 ? high[1] : low[1],
           (index & 4) != 0 ? high[2] : low[2]}};
}

// How near the eye may come along one axis of the picture. A point at x (in units of the slope) and z towards
// the eye is inside when |x - shift| <= distance - z: for the two extremes, that is the crossing of two
// straight lines.
struct Fit {
  float positive = -1e30f;  // largest z + x
  float negative = -1e30f;  // largest z - x

  void add(float x, float z) {
    positive = std::max(positive, z + x);
    negative = std::max(negative, z - x);
  }
  float distance() const { return 0.5f * (positive + negative); }
  float shift() const { return 0.5f * (positive - negative); }
};

}  // namespace

Vec<3> cross(const Vec<3>& a, const Vec<3>& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

Basis basis_along(const Vec<3>& along) {
  const Vec<3> w = unit(along);
  Vec<3> t = w;
  t[smallest_axis(w)] = 1;
  const Vec<3> u = unit(cross(t, w));
  return {u, cross(w, u), w};
}

Viewpoint flat_view(const Vec<3>& low, const Vec<3>& high, float margin) {
  Viewpoint viewpoint;
  viewpoint.low = low;
  viewpoint.high = high;
  viewpoint.margin = margin;
  return viewpoint;
}

Viewpoint look_at(const Vec<3>& eye, const Vec<3>& target, const Vec<3>& up, float field_of_view) {
  Viewpoint viewpoint;
  viewpoint.in_space = true;
  viewpoint.eye = eye;
  viewpoint.target = target;
  viewpoint.up = up;
  viewpoint.field_of_view = field_of_view;
  return viewpoint;
}

Viewpoint fit_box(const Vec<3>& low, const Vec<3>& high, const Vec<3>& towards_eye, const Vec<3>& up,
                  float aspect, float field_of_view) {
  const Vec<3> centre = (low + high) * 0.5f;
  const Vec<3> back = unit(towards_eye);
  const Basis axes = view_axes(back * -1.0f, up);
  const float slope_y = half_slope(field_of_view) * (1.0f - free_border);
  const float slope_x = slope_y * aspect;
  Fit across;
  Fit upwards;
  float reach = 0;
  for (int index = 0; index < 8; ++index) {
    const Vec<3> offset = corner(low, high, index) - centre;
    const float z = dot(offset, back);
    across.add(dot(offset, axes.u) / slope_x, z);
    upwards.add(dot(offset, axes.v) / slope_y, z);
    reach = std::max(reach, z);
  }
  const float distance = std::max({across.distance(), upwards.distance(), 1e-6f});
  const Vec<3> target = centre + axes.u * (across.shift() * slope_x) + axes.v * (upwards.shift() * slope_y);
  Viewpoint viewpoint = look_at(target + back * distance, target, up, field_of_view);
  viewpoint.fade_from = distance - reach;
  viewpoint.fade_to = distance + reach;
  return viewpoint;
}

Viewpoint three_quarter_view(const Vec<3>& low, const Vec<3>& high, float aspect, float field_of_view) {
  return fit_box(low, high, Vec<3>{{0.52f, 0.34f, 0.78f}}, Vec<3>{{0, 1, 0}}, aspect, field_of_view);
}

Projection::Projection(const Viewpoint& viewpoint, Size size) : viewpoint_(viewpoint) {
  centre_x_ = 0.5f * static_cast<float>(size.width);
  centre_y_ = 0.5f * static_cast<float>(size.height);
  if (viewpoint.in_space) {
    const Vec<3> view = viewpoint.target - viewpoint.eye;
    const Basis axes = view_axes(dot(view, view) > 0 ? unit(view) : Vec<3>{{0, 0, -1}}, viewpoint.up);
    right_ = axes.u;
    up_ = axes.v;
    forward_ = axes.w;
    scale_ = centre_y_ / half_slope(viewpoint.field_of_view);
    near_ = std::max(1e-3f * length(view), 1e-6f);
    return;
  }
  middle_ = (viewpoint.low + viewpoint.high) * 0.5f;
  const Vec<3> extent = viewpoint.high - viewpoint.low;
  const float free_x = std::max(1.0f, static_cast<float>(size.width) - 2 * viewpoint.margin);
  const float free_y = std::max(1.0f, static_cast<float>(size.height) - 2 * viewpoint.margin);
  const float scale =
      std::min(extent[0] > 0 ? free_x / extent[0] : 1e30f, extent[1] > 0 ? free_y / extent[1] : 1e30f);
  scale_ = scale < 1e30f ? scale : 1.0f;
}

Projected Projection::project(const Vec<3>& point) const {
  if (!is_finite(point)) return {};
  if (!viewpoint_.in_space) {
    return {centre_x_ + (point[0] - middle_[0]) * scale_, centre_y_ - (point[1] - middle_[1]) * scale_, 0,
            scale_, true};
  }
  const Vec<3> offset = point - viewpoint_.eye;
  const float depth = dot(offset, forward_);
  // Half the clipping distance, so that a line clipped to it is in front whatever the rounding.
  if (!(depth > 0.5f * near_)) return {};
  const float scale = scale_ / depth;
  return {centre_x_ + dot(offset, right_) * scale, centre_y_ - dot(offset, up_) * scale, depth, scale, true};
}

bool Projection::clip(Vec<3>& from, Vec<3>& to) const {
  if (!is_finite(from) || !is_finite(to)) return false;
  if (!viewpoint_.in_space) return true;
  const float depth_from = depth_of(from);
  const float depth_to = depth_of(to);
  if (depth_from < near_ && depth_to < near_) return false;
  if (depth_from < near_) from = to + (from - to) * ((depth_to - near_) / (depth_to - depth_from));
  if (depth_to < near_) to = from + (to - from) * ((depth_from - near_) / (depth_from - depth_to));
  return true;
}

float Projection::fade(float depth) const {
  if (!(viewpoint_.fade_to > viewpoint_.fade_from)) return 0;
  return std::clamp((depth - viewpoint_.fade_from) / (viewpoint_.fade_to - viewpoint_.fade_from), 0.0f, 1.0f);
}

}  // namespace sturnus
