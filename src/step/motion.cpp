// One boid at a time: Euler, speed limits, random turn, the edge of the space.
#include "step/motion.h"

#include <algorithm>

#include "step/jump.h"
#include "world/columns.h"

namespace sturnus {
namespace {

template <int D>
bool all_sound(const Vec<D>& v) {
  for (int axis = 0; axis < D; ++axis) {
    if (!is_sound(v[axis])) return false;
  }
  return true;
}

template <int D>
Vec<D> steered_velocity(Motion<D>& motion, const FlockModel& flock, const Vec<D>& old, std::size_t i) {
  const Model& model = motion.model;
  Vec<D> velocity = old + motion.steering.acceleration(i) * model.dt;
  velocity = limited(velocity, flock.min_speed, flock.max_speed);
  if (flock.noise_turn == 0) return velocity;
  return turned_at_random(velocity, flock.noise_turn, motion.state.id[i], {model.seed, motion.state.step});
}

// Velocity, limits, place, boundary. Who would go bad stays and is put out of play.
template <int D>
void move_boid(Motion<D>& motion, std::size_t i) {
  const Model& model = motion.model;
  const FlockModel& flock = model.flocks[motion.state.flock[i]];
  const auto old_position = at<D>(motion.state.position, i);
  const auto old_velocity = at<D>(motion.state.velocity, i);
  Vec<D> velocity = is_jumping(motion.state, flock, i)
                        ? jump_velocity(*flock.jump, motion.state.life.jump[i], old_velocity)
                        : steered_velocity(motion, flock, old_velocity, i);
  const bool semi_implicit = model.integrator == Integrator::semi_implicit_euler;
  Vec<D> position = old_position + (semi_implicit ? velocity : old_velocity) * model.dt;
  const bool was_sound = all_sound(position) && all_sound(velocity);
  if (was_sound) keep_inside(model, position, velocity);
  if (!was_sound || !all_sound(position)) {
    motion.part.fallen.push_back(static_cast<std::uint32_t>(i));
    position = old_position;
    velocity = {};
  }
  put(motion.scratch.previous_position, i, position);
  put(motion.scratch.previous_velocity, i, velocity);
}

}  // namespace

template <int D>
void move_plain(Motion<D>& motion, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    if (motion.state.quarantined[i] == 0) move_boid(motion, i);
  }
}

template void move_plain<2>(Motion<2>&, std::size_t, std::size_t);
template void move_plain<3>(Motion<3>&, std::size_t, std::size_t);

}  // namespace sturnus
