// From accelerations to velocities and places: Euler, speed limits, random turn, the edge of the space.
#include <algorithm>

#include "rules/rules.h"
#include "step/step.h"
#include "world/columns.h"
#include "world/state.h"

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
void move_boid(const Model& model, State& state, const Scratch& scratch, std::size_t i) {
  const FlockModel& flock = model.flocks[state.flock[i]];
  const auto old_position = at<D>(state.position, i);
  const auto old_velocity = at<D>(state.velocity, i);
  Vec<D> velocity = old_velocity + at<D>(scratch.acceleration, i) * model.dt;
  velocity = limited(velocity, flock.min_speed, flock.max_speed);
  if (flock.noise_turn != 0)
    velocity = turned_at_random(velocity, flock.noise_turn, state.id[i], {model.seed, state.step});
  const bool semi_implicit = model.integrator == Integrator::semi_implicit_euler;
  Vec<D> position = old_position + (semi_implicit ? velocity : old_velocity) * model.dt;
  const bool was_sound = all_sound(position) && all_sound(velocity);
  if (was_sound) keep_inside(model, position, velocity);
  if (!was_sound || !all_sound(position)) {
    state.quarantined[i] = 1;
    position = old_position;
    velocity = {};
  }
  put(state.position, i, position);
  put(state.velocity, i, velocity);
}

void copy_part(const Columns& from, Columns& to, std::size_t begin, std::size_t end) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!from[axis].empty()) std::copy_n(from[axis].data() + begin, end - begin, to[axis].data() + begin);
  }
}

template <int D>
void integrate_in(const Model& model, State& state, Scratch& scratch, const Workers& workers) {
  workers.for_ranges(state.size(), [&](std::size_t begin, std::size_t end, int) {
    copy_part(state.position, scratch.previous_position, begin, end);
    copy_part(state.velocity, scratch.previous_velocity, begin, end);
    for (std::size_t i = begin; i < end; ++i) {
      if (state.quarantined[i] == 0) move_boid<D>(model, state, scratch, i);
    }
  });
}

}  // namespace

void integrate(const Model& model, State& state, Scratch& scratch, const Workers& workers) {
  fit(scratch.previous_position, model.dimensions, state.size());
  fit(scratch.previous_velocity, model.dimensions, state.size());
  model.dimensions == 3 ? integrate_in<3>(model, state, scratch, workers)
                        : integrate_in<2>(model, state, scratch, workers);
}

}  // namespace sturnus
