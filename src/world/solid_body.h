// A body among solid obstacles: where it may stand, where its motion ends, and the nearest way out.
#pragma once

#include <algorithm>
#include <cmath>

#include "world/obstacle_index.h"
#include "world/state.h"

namespace sturnus {

/// One body of a radius (length) among the obstacles of an index.
template <int D>
class Solids {
 public:
  Solids(const Model& model, const ObstacleIndex& obstacles, float body)
      : model_(model), obstacles_(obstacles), body_(double{body}) {}

  /// Ends a motion from `old` to `position` where it first meets something. Who was free stays free.
  void keep_out(const Vec<D>& old, Vec<D>& position, Vec<D>& velocity) const {
    const Place<D> from = place_of(old);
    const Place<D> motion = way(model_, from, place_of(position));
    const double far = length(motion);
    const double room = room_at(old, far);
    if (room > far * (1 + 1e-9)) return;  // nothing is as near as the new place
    if (room < 0) return climb_out(old, position, velocity);
    Met met{1, {}, 0};
    obstacles_.visit(old, body_ + far, [&](const Obstacle& obstacle) { hit(obstacle, from, motion, met); });
    if (met.size > 0) {
      drop_inward(velocity, met.out);
      position = settled(from + motion * met.t + met.out * (gap * met.size));
    }
    if (!is_free(position)) position = old;
  }

  /// Outside of all obstacles.
  bool is_outside(const Vec<D>& at) const { return !(room_at(at, 0) < 0); }

  /// The same, and inside of a world that nobody leaves.
  bool is_free(const Vec<D>& at) const {
    for (int axis = 0; axis < D && model_.boundary == BoundaryKind::bounce; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      if (!(at[axis] >= model_.min[i] && at[axis] <= model_.max[i])) return false;
    }
    return is_outside(at);
  }

  /// Brings a place to the nearest surface, and on from there where that is not free; false, with the place
  /// as it was, where that finds nothing.
  bool bring_out(Vec<D>& place) const {
    Vec<D> at = inside(settled(place_of(place)));
    for (int climb = 0; climb < most_climbs; ++climb) {
      double size = 0;
      const Surface<D> nearest = deepest(at, size);
      if (!(nearest.distance < 0)) break;
      at = inside(settled(place_of(at) + nearest.out * (gap * size - nearest.distance)));
    }
    if (!is_free(at)) return false;
    place = at;
    return true;
  }

 private:
  static constexpr double gap = 1e-4;  // of an obstacle's size: how far before it a body stops
  static constexpr int most_climbs =
      8;  // surfaces one after the other on the way out of overlapping obstacles

  struct Met {
    double t;
    Place<D> out;
    double size;  ///< 0 while nothing is met
  };

  double size_of(const Obstacle& obstacle) const {
    if (obstacle.kind == ObstacleKind::sphere) return double{obstacle.radius} + body_;
    double size = 0;
    for (int axis = 0; axis < D; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      const bool is_box = obstacle.kind == ObstacleKind::box;
      // A plane has no size: it counts as a hundredth of the space.
      const double side = is_box ? double{obstacle.half[i]} : 0.01 * double{model_.size[i]};
      size = axis == 0 || side < size ? side : size;
    }
    return size + body_;
  }

  // The distance to the nearest surface, negative inside; any that is farther than `far` may be left out.
  double room_at(const Vec<D>& at, double far) const {
    double room = double{FlockModel::infinity_f};
    const Place<D> from = place_of(at);
    obstacles_.visit(at, body_ + far, [&](const Obstacle& obstacle) {
      const auto one = surface(obstacle, way(model_, from, place_of<D>(obstacle.at)), body_);
      if (one.distance < room) room = one.distance;
    });
    return room;
  }

  // The surface of the obstacle that the boid is in most deeply; a positive distance where it is in none.
  Surface<D> deepest(const Vec<D>& at, double& size) const {
    Surface<D> found{1, {}};
    const Place<D> from = place_of(at);
    obstacles_.visit(at, body_, [&](const Obstacle& obstacle) {
      const auto one = surface(obstacle, way(model_, from, place_of<D>(obstacle.at)), body_);
      if (!(one.distance < 0 && one.distance < found.distance)) return;
      found = one;
      size = size_of(obstacle);
    });
    return found;
  }

  // The place as the state keeps it.
  Vec<D> settled(const Place<D>& place) const {
    Vec<D> at = rounded(place);
    for (int axis = 0; axis < D && model_.wraps(); ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      at[axis] = wrapped(at[axis], model_.min[i], model_.max[i]);
    }
    return at;
  }

  // Not beyond the edge of a world that nobody leaves.
  Vec<D> inside(Vec<D> at) const {
    for (int axis = 0; axis < D && model_.boundary == BoundaryKind::bounce; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      at[axis] = std::clamp(at[axis], model_.min[i], model_.max[i]);
    }
    return at;
  }

  static void drop_inward(Vec<D>& velocity, const Place<D>& out) {
    const double inward = dot(place_of(velocity), out);
    if (inward < 0) velocity = rounded(place_of(velocity) - out * inward);
  }

  // The images of an obstacle that a motion may reach: the nearest, and on each axis the one beyond where it
  // comes near enough.
  void hit(const Obstacle& obstacle, const Place<D>& from, const Place<D>& motion, Met& met) const {
    const Place<D> nearest = way(model_, from, place_of<D>(obstacle.at));
    for (unsigned images = 0; images < 1u << D; ++images) {
      Place<D> o = nearest;
      bool is_reached = true;
      for (int axis = 0; axis < D; ++axis) {
        if ((images >> axis & 1) == 0) continue;
        const auto i = static_cast<std::size_t>(axis);
        const double size = double{model_.size[i]};
        o[axis] += o[axis] > 0 ? -size : size;
        const double wide = double{obstacle.radius} + double{obstacle.half[i]} + body_;
        is_reached = is_reached && model_.wraps() && std::abs(o[axis]) <= std::abs(motion[axis]) + wide;
      }
      if (is_reached) hit_image(obstacle, o, motion, met);
    }
  }

  void hit_image(const Obstacle& obstacle, const Place<D>& o, const Place<D>& motion, Met& met) const {
    const auto one = meet(obstacle, o, motion, body_);
    if (!one || one->t > 1 || (met.size > 0 && !(one->t < met.t))) return;
    met = {one->t, one->out, size_of(obstacle)};
  }

  // From the inside to the nearest surface, and on from there where that is inside of another obstacle.
  void climb_out(const Vec<D>& old, Vec<D>& position, Vec<D>& velocity) const {
    Vec<D> at = old;
    for (int climb = 0; climb < most_climbs; ++climb) {
      double size = 0;
      const Surface<D> nearest = deepest(at, size);
      if (!(nearest.distance < 0)) break;
      at = settled(place_of(at) + nearest.out * (gap * size - nearest.distance));
      drop_inward(velocity, nearest.out);
    }
    if (is_free(at)) {
      position = at;
    } else if (!is_free(position)) {
      position = old;
    }
  }

  const Model& model_;
  const ObstacleIndex& obstacles_;
  double body_;
};

}  // namespace sturnus
