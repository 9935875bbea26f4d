// The jump of a hunter: straight ahead, without steering (CS 184).
#pragma once

#include "base/vec.h"
#include "scenario/model.h"
#include "world/state.h"

namespace sturnus {

inline bool is_jumping(const State& state, const FlockModel& flock, std::size_t i) {
  return flock.jump && state.life.jump[i] > 0;
}

/// Along the heading at a speed that falls evenly until the jump is over; `left` is what is left of it.
template <int D>
Vec<D> jump_velocity(const JumpModel& jump, double left, const Vec<D>& velocity) {
  const auto part = static_cast<float>(left < jump.duration ? left / jump.duration : 1.0);
  return unit(velocity) * (jump.end_speed + (jump.speed - jump.end_speed) * part);
}

}  // namespace sturnus
