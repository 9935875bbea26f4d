// Solid obstacles: after a step's motion the way from the old place to the new one is swept, and every place
// is looked at once more, as it is rounded, before a boid may stand there.
#include <algorithm>
#include <cmath>

#include "step/motion.h"
#include "world/columns.h"

namespace sturnus {
namespace {

constexpr double gap = 1e-4;    // of an obstacle's size: how far before it a boid stops
constexpr int most_climbs = 8;  // surfaces one after the other on the way out of overlapping obstacles

// One boid of a size among the obstacles.
template <int D>
class Solids {
 public:
  Solids(const Model& model, const ObstacleIndex& obstacles, float body)
      : model_(model), obstacles_(obstacles), body_(double{body}) {}

  void keep_out(const Vec<D>& old, Vec<D>& position, Vec<D>& velocity) const {
    const Place<D> from = place_of(old);
    const Place<D> motion = way(model_, from, place_of(position));
    const double far = length(motion);
    const double room = room_at(old, far);
    if (room > far * (1 + 1e-9)) return;  // nothing is as near as the new place
    if (room < 0) return bring_out(old, position, velocity);
    Met met{1, {}, 0};
    obstacles_.visit(old, body_ + far, [&](const Obstacle& obstacle) { hit(obstacle, from, motion, met); });
    if (met.size > 0) {
      drop_inward(velocity, met.out);
      position = settled(from + motion * met.t + met.out * (gap * met.size));
    }
    if (!is_free(position)) position = old;
  }

 private:
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

  // Outside of all obstacles, and inside of a world that nobody leaves.
  bool is_free(const Vec<D>& at) const {
    for (int axis = 0; axis < D && model_.boundary == BoundaryKind::bounce; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      if (!(at[axis] >= model_.min[i] && at[axis] <= model_.max[i])) return false;
    }
    return !(room_at(at, 0) < 0);
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
  void bring_out(const Vec<D>& old, Vec<D>& position, Vec<D>& velocity) const {
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

}  // namespace

template <int D>
void keep_out(Motion<D>& motion, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    if (motion.state.quarantined[i] != 0) continue;
    const FlockModel& flock = motion.model.flocks[motion.state.flock[i]];
    const Solids<D> solids(motion.model, motion.scratch.obstacles, flock.body_radius);
    auto position = at<D>(motion.scratch.previous_position, i);
    auto velocity = at<D>(motion.scratch.previous_velocity, i);
    solids.keep_out(at<D>(motion.state.position, i), position, velocity);
    put(motion.scratch.previous_position, i, position);
    put(motion.scratch.previous_velocity, i, velocity);
  }
}

template void keep_out<2>(Motion<2>&, std::size_t, std::size_t);
template void keep_out<3>(Motion<3>&, std::size_t, std::size_t);

}  // namespace sturnus
