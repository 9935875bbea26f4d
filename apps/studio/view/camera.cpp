// The plane from above, space in perspective; y is up in both.
#include "view/camera.h"

#include <algorithm>

namespace studio {
namespace {

constexpr float degree = 0.017453292519943295f;
constexpr float free_border = 0.06f;    // part of half the window that a fitted box leaves free
constexpr float steepest = 1.55f;       // radians; straight up there would be no right and left
constexpr float near_part = 0.01f;      // nearest drawn depth, of the distance to the middle
constexpr float smallest_span = 1e-4f;  // length

Point corner(const sturnus::Extent& extent, int index) {
  Point out{};
  for (std::size_t axis = 0; axis < extent.min.size() && axis < 3; ++axis)
    out[axis] = static_cast<float>((index >> axis & 1) != 0 ? extent.max[axis] : extent.min[axis]);
  return out;
}

// How near the eye may come along one axis of the window. A point at x (in units of the slope) and z towards
// the eye is inside when |x - shift| <= distance - z: for the two extremes, that is the crossing of two
// lines.
struct Sides {
  float positive = -1e30f, negative = -1e30f;  // largest z + x, largest z - x

  void add(float x, float z) {
    positive = std::max(positive, z + x);
    negative = std::max(negative, z - x);
  }
  float distance() const { return 0.5f * (positive + negative); }
  float shift() const { return 0.5f * (positive - negative); }
};

}  // namespace

float distance(const Ray& ray, const Point& point) {
  return length(cross(point - ray.from, ray.along));
}

float Camera::half_slope() const {
  return std::tan(0.5f * field_of_view_ * degree);
}

Point Camera::towards_eye() const {
  const float flat = std::cos(tilt_);
  return {std::sin(turn_) * flat, std::sin(tilt_), std::cos(turn_) * flat};
}

Point Camera::forward() const {
  return dimensions_ == 2 ? Point{0, 0, -1} : towards_eye() * -1.0f;
}

Point Camera::right() const {
  return dimensions_ == 2 ? Point{1, 0, 0} : Point{std::cos(turn_), 0, -std::sin(turn_)};
}

Point Camera::up() const {
  return dimensions_ == 2 ? Point{0, 1, 0} : cross(right(), forward());
}

Point Camera::eye() const {
  return middle_ - forward() * span_;
}

void Camera::fit(const sturnus::Extent& extent, int dimensions) {
  const Camera usual;
  dimensions_ = dimensions;
  turn_ = usual.turn_;
  tilt_ = usual.tilt_;
  middle_ = (corner(extent, 0) + corner(extent, 7)) * 0.5f;
  const float aspect = static_cast<float>(pixels_.width) / static_cast<float>(pixels_.height);
  const float slope = (dimensions == 2 ? 0.5f : half_slope()) * (1 - free_border);
  const float wide = slope * aspect * free_x_, high = slope * free_y_;
  Sides across, upwards;
  for (int index = 0; index < 8; ++index) {
    const Point offset = corner(extent, index) - middle_;
    const float nearer = dimensions == 2 ? 0 : -dot(offset, forward());
    across.add(dot(offset, right()) / wide, nearer);
    upwards.add(dot(offset, up()) / high, nearer);
  }
  const float needed = std::max(across.distance(), upwards.distance());
  span_ = std::isfinite(needed) && needed > smallest_span ? needed : 100;
  if (span_ == needed)
    middle_ = middle_ + right() * (across.shift() * wide) + up() * (upwards.shift() * high);
}

void Camera::resize(sturnus::Size pixels, const std::array<float, 4>& covered) {
  pixels_ = {std::max(1, pixels.width), std::max(1, pixels.height)};
  const auto width = static_cast<float>(pixels_.width), height = static_cast<float>(pixels_.height);
  shift_x_ = (covered[0] - covered[2]) / width;
  shift_y_ = (covered[3] - covered[1]) / height;
  free_x_ = std::max(0.2f, 1 - (covered[0] + covered[2]) / width);
  free_y_ = std::max(0.2f, 1 - (covered[1] + covered[3]) / height);
}

void Camera::fill() {
  const float part = std::max(free_x_, free_y_);
  if (dimensions_ == 2) span_ *= part;
  if (dimensions_ == 3) field_of_view_ = 2 * std::atan(half_slope() * part) / degree;
  shift_x_ = shift_y_ = 0;
  free_x_ = free_y_ = 1;
}

void Camera::pan(float dx, float dy) {
  const float by = pixel_length(middle_);
  middle_ = middle_ + up() * (dy * by) - right() * (dx * by);
}

void Camera::zoom(float factor, float x, float y) {
  if (!(factor > 0)) return;
  const Point before = place(x, y, middle_);
  span_ = std::clamp(span_ / factor, smallest_span, 1e9f);
  middle_ = middle_ + before - place(x, y, middle_);
}

void Camera::turn(float dx, float dy) {
  const float by = 3.0f / static_cast<float>(pixels_.height);
  turn_ -= dx * by;
  tilt_ = std::clamp(tilt_ + dy * by, -steepest, steepest);
}

void Camera::orbit(float dx, float dy) {
  if (dimensions_ == 2) return pan(dx, dy);
  turn(dx, dy);
}

void Camera::fly(float right_part, float up_part, float forward_part) {
  middle_ = middle_ + (right() * right_part + up() * up_part) * span_;
  if (dimensions_ == 3) middle_ = middle_ + forward() * (forward_part * span_);
}

void Camera::look(float dx, float dy) {
  if (dimensions_ == 2) return pan(dx, dy);
  const Point stays = eye();
  turn(dx, dy);
  middle_ = stays + forward() * span_;
}

void Camera::follow(const Point& point, float part) {
  middle_ = middle_ + (point - middle_) * part;
}

std::array<float, 16> Camera::matrix() const {
  const float aspect = static_cast<float>(pixels_.width) / static_cast<float>(pixels_.height);
  const float scale = dimensions_ == 2 ? 2 / span_ : 1 / half_slope();
  const Point from = dimensions_ == 2 ? middle_ : eye();
  const Point w = dimensions_ == 2 ? Point{} : forward();
  const Point x = right() * (scale / aspect), y = up() * scale;
  const Point shifted_x = x + w * shift_x_, shifted_y = y + w * shift_y_;
  const float upright = dimensions_ == 2 ? 1.0f : 0.0f;
  // There is no farthest depth: what leaves an open space is still there.
  const float start = dimensions_ == 2 ? 0.0f : 2 * nearest();
  std::array<float, 16> out{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    out[4 * axis] = shifted_x[axis];
    out[4 * axis + 1] = shifted_y[axis];
    out[4 * axis + 2] = out[4 * axis + 3] = w[axis];
  }
  out[12] = shift_x_ * upright - dot(shifted_x, from);
  out[13] = shift_y_ * upright - dot(shifted_y, from);
  out[14] = -dot(w, from) - start;
  out[15] = upright - dot(w, from);
  return out;
}

float Camera::nearest() const {
  return near_part * span_;
}

float Camera::pixel_length(const Point& at) const {
  const auto height = static_cast<float>(pixels_.height);
  if (dimensions_ == 2) return span_ / height;
  return std::max(nearest(), dot(at - eye(), forward())) * 2 * half_slope() / height;
}

Ray Camera::ray(float x, float y) const {
  const auto width = static_cast<float>(pixels_.width);
  const auto height = static_cast<float>(pixels_.height);
  const float across = (2 * x - width * (1 + shift_x_)) / height;
  const float upwards = 1 - shift_y_ - 2 * y / height;
  if (dimensions_ == 2)
    return {middle_ + (right() * across + up() * upwards) * (0.5f * span_) - forward() * span_, forward()};
  return {eye(), unit(forward() + (right() * across + up() * upwards) * half_slope())};
}

Point Camera::place(float x, float y, const Point& through) const {
  const Ray seen = ray(x, y);
  const Point target = dimensions_ == 2 ? Point{} : through;
  const float depth = dot(target - seen.from, forward()) / dot(seen.along, forward());
  return seen.from + seen.along * depth;
}

Point Camera::project(const Point& at) const {
  const auto width = static_cast<float>(pixels_.width);
  const auto height = static_cast<float>(pixels_.height);
  const Point offset = at - (dimensions_ == 2 ? middle_ : eye());
  const float depth = dimensions_ == 2 ? 1 : dot(offset, forward());
  const float scale = dimensions_ == 2 ? height / span_ : 0.5f * height / (half_slope() * depth);
  return {0.5f * width * (1 + shift_x_) + dot(offset, right()) * scale,
          0.5f * height * (1 - shift_y_) - dot(offset, up()) * scale, depth};
}

}  // namespace studio
