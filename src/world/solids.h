// Obstacles as shapes: how far a place is from one, and where a ray meets it. In double, from the float bits
// of the state.
//
// A shape is made thicker all round by the radius of what touches it; a box becomes a larger box. `o` is
// always the offset from the place to the obstacle's `at`.
#pragma once

#include <cmath>
#include <optional>

#include "base/vec.h"
#include "scenario/model.h"
#include "sturnus/view.h"

namespace sturnus {

template <int D>
using Place = Vec<D, double>;

template <int D>
Place<D> place_of(const Vec<D>& v) {
  Place<D> out;
  for (int axis = 0; axis < D; ++axis) out[axis] = double{v[axis]};
  return out;
}
template <int D>
Place<D> place_of(const std::array<float, 3>& v) {
  return place_of(narrow_to<D>(v));
}
template <int D>
Vec<D> rounded(const Place<D>& v) {
  Vec<D> out;
  for (int axis = 0; axis < D; ++axis) out[axis] = static_cast<float>(v[axis]);
  return out;
}

/// to - from by the nearest image where the space wraps, chosen by comparison.
template <int D>
Place<D> way(const Model& model, const Place<D>& from, const Place<D>& to) {
  Place<D> o = to - from;
  if (!model.wraps()) return o;
  for (int axis = 0; axis < D; ++axis) {
    const double size = double{model.size[static_cast<std::size_t>(axis)]};
    if (o[axis] > 0.5 * size) {
      o[axis] -= size;
    } else if (o[axis] < -0.5 * size) {
      o[axis] += size;
    }
  }
  return o;
}

/// How far a place lies from a surface, negative inside, and the unit vector out.
template <int D>
struct Surface {
  double distance = 0;
  Place<D> out;
};

/// The surface of a thickened obstacle; of a box that of the nearest face's plane.
template <int D>
Surface<D> surface(const Obstacle& obstacle, const Place<D>& o, double thicker) {
  Surface<D> found;
  if (obstacle.kind == ObstacleKind::plane) {
    found.out = place_of<D>(obstacle.normal);
    found.distance = -dot(o, found.out) - thicker;
  } else if (obstacle.kind == ObstacleKind::sphere) {
    const double distance = length(o);
    found.distance = distance - (double{obstacle.radius} + thicker);
    found.out = unit(o) * -1.0;
    if (!(distance > 0)) found.out[0] = 1;  // at the centre every way is as good
  } else {
    int face = 0;
    for (int axis = 0; axis < D; ++axis) {
      const double past =
          std::abs(o[axis]) - (double{obstacle.half[static_cast<std::size_t>(axis)]} + thicker);
      if (axis > 0 && !(past > found.distance)) continue;
      found.distance = past;
      face = axis;
    }
    found.out[face] = o[face] > 0 ? -1 : 1;
  }
  return found;
}

/// From a place to the nearest point of a box that is not thickened; zero inside.
template <int D>
Place<D> way_to_box(const Obstacle& box, const Place<D>& o) {
  Place<D> out;
  for (int axis = 0; axis < D; ++axis) {
    const double half = double{box.half[static_cast<std::size_t>(axis)]};
    const double past = std::abs(o[axis]) - half;
    if (past > 0) out[axis] = o[axis] > 0 ? past : -past;
  }
  return out;
}

/// Where a ray first meets a shape: t times its direction on the way, and the unit vector out of the shape.
/// Who starts inside meets it at t = 0. A shape behind is not met.
template <int D>
struct Meeting {
  double t = 0;
  Place<D> out;
};

/// |t·d - o| = radius by its quadratic; a tangent counts.
template <int D>
std::optional<double> meet_sphere(const Place<D>& o, const Place<D>& d, double radius) {
  const double c = dot(o, o) - radius * radius;
  if (c < 0) return 0.0;
  const double a = dot(d, d);
  const double half_b = dot(o, d);
  if (!(half_b > 0)) return {};
  const double discriminant = half_b * half_b - a * c;
  if (discriminant < 0) return {};
  // c over the larger root, which keeps its digits where the plain form would lose them.
  return c / (half_b + std::sqrt(discriminant));
}

template <int D>
std::optional<Meeting<D>> meet_box(const Obstacle& box, const Place<D>& o, const Place<D>& d,
                                   double thicker) {
  const Surface<D> start = surface(box, o, thicker);
  if (start.distance < 0) return Meeting<D>{0, start.out};
  double enter = -FlockModel::infinity_f, leave = FlockModel::infinity_f;
  int face = 0;
  for (int axis = 0; axis < D; ++axis) {
    const double half = double{box.half[static_cast<std::size_t>(axis)]} + thicker;
    if (d[axis] == 0) {
      if (std::abs(o[axis]) >= half) return {};
      continue;
    }
    const double side = d[axis] > 0 ? half : -half;
    const double in = (o[axis] - side) / d[axis];
    const double out = (o[axis] + side) / d[axis];
    if (in > enter) {
      enter = in;
      face = axis;
    }
    if (out < leave) leave = out;
  }
  if (!(enter >= 0 && enter < leave)) return {};
  Meeting<D> met{enter, {}};
  met.out[face] = d[face] > 0 ? -1 : 1;
  return met;
}

template <int D>
std::optional<Meeting<D>> meet(const Obstacle& obstacle, const Place<D>& o, const Place<D>& d,
                               double thicker) {
  if (obstacle.kind == ObstacleKind::box) return meet_box(obstacle, o, d, thicker);
  if (obstacle.kind == ObstacleKind::sphere) {
    const auto t = meet_sphere(o, d, double{obstacle.radius} + thicker);
    if (!t) return {};
    return Meeting<D>{*t, surface(obstacle, o - d * *t, thicker).out};
  }
  const Surface<D> start = surface(obstacle, o, thicker);
  if (start.distance < 0) return Meeting<D>{0, start.out};
  const double approach = -dot(d, start.out);
  if (!(approach > 0)) return {};
  return Meeting<D>{start.distance / approach, start.out};
}

}  // namespace sturnus
