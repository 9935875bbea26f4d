// Bad numbers: one bad boid is put out of play and counted, and spoils nobody else.
#include <cmath>

#include "step/step.h"

namespace sturnus {

bool is_sound(float value) { return std::abs(value) <= 1e15f; }

void quarantine(const Model& model, State& state) {
  const auto axes = static_cast<std::size_t>(model.dimensions);
  for (std::size_t i = 0; i < state.size(); ++i) {
    bool sound = true;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      sound = sound && is_sound(state.position[axis][i]) && is_sound(state.velocity[axis][i]);
    }
    if (sound) continue;
    state.quarantined[i] = 1;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      state.velocity[axis][i] = 0;
      // No earlier place is known here: what is bad becomes the middle of the space.
      if (!is_sound(state.position[axis][i])) state.position[axis][i] = model.min[axis] + 0.5f * model.size[axis];
    }
  }
}

}  // namespace sturnus
