// Bad numbers: one bad boid is put out of play and counted, and spoils nobody else.
#include <atomic>

#include "step/step.h"
#include "world/state.h"

namespace sturnus {

namespace {

bool all_sound(const Columns& columns, std::size_t i) {
  for (const auto& column : columns) {
    if (!column.empty() && !is_sound(column[i])) return false;
  }
  return true;
}

// Puts something harmless in the place of what is bad: the given value on the first axis, 0 on the others.
void mend(Columns& columns, std::size_t i, float first) {
  if (all_sound(columns, i)) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!columns[axis].empty()) columns[axis][i] = axis == 0 ? first : 0;
  }
}

bool all_sound(const Columns& columns, std::size_t begin, std::size_t end) {
  unsigned bad = 0;  // rather than bool, for the sake of speed
  for (const auto& column : columns) {
    if (column.empty()) continue;
    for (std::size_t i = begin; i < end; ++i) bad |= is_sound(column[i]) ? 0u : 1u;
  }
  return bad == 0;
}

// Whether all values of all boids are sound, column by column: nearly always so, and fast to see.
bool all_sound(const State& state, const Workers& workers) {
  std::atomic<bool> sound = true;
  workers.for_ranges(state.size(), [&](std::size_t begin, std::size_t end, int) {
    for (const Columns* columns : {&state.position, &state.velocity, &state.wander, &state.colour}) {
      if (!all_sound(*columns, begin, end)) sound = false;
    }
  });
  return sound;
}

}  // namespace

void quarantine(const Model& model, State& state, const Workers& workers) {
  if (all_sound(state, workers)) return;
  const auto axes = static_cast<std::size_t>(model.dimensions);
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (all_sound(state.position, i) && all_sound(state.velocity, i) && all_sound(state.wander, i) &&
        all_sound(state.colour, i)) {
      continue;
    }
    state.quarantined[i] = 1;
    mend(state.wander, i, 1);
    mend(state.colour, i, 0);
    for (std::size_t axis = 0; axis < axes; ++axis) {
      state.velocity[axis][i] = 0;
      // No earlier place is known here: what is bad becomes the middle of the space.
      if (!is_sound(state.position[axis][i]))
        state.position[axis][i] = model.min[axis] + 0.5f * model.size[axis];
    }
  }
}

}  // namespace sturnus
