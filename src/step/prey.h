// Whom a hunter hunts, and whether it sees them.
#pragma once

#include <cmath>

#include "world/columns.h"
#include "world/state.h"

namespace sturnus {

/// A boid of a hunted flock, as a hunter finds it.
template <int D>
struct Prey {
  std::uint32_t slot = 0;
  float distance_squared = 0;
  Vec<D> offset;  ///< from the hunter to it
};

inline bool is_hunted(const HuntModel& hunt, const State& state, std::size_t slot) {
  return (hunt.prey >> state.flock[slot] & 1) != 0 && state.quarantined[slot] == 0;
}

template <int D>
Prey<D> prey_at(const State& state, std::size_t hunter, std::size_t slot, const Wrapping& image) {
  const Vec<D> o = offset(at<D>(state.position, hunter), at<D>(state.position, slot), image);
  return {static_cast<std::uint32_t>(slot), dot(o, o), o};
}

/// Within the distance and the field of view; `speed` is the length of `velocity`.
template <int D>
bool is_seen(const SightModel& sight, const Vec<D>& velocity, float speed, const Prey<D>& prey) {
  if (!(prey.distance_squared < sight.distance_squared)) return false;
  if (sight.sees_all) return true;
  return dot(velocity, prey.offset) >= sight.cos_half_view * speed * std::sqrt(prey.distance_squared);
}

/// Whether it is full, and hunts nobody.
inline bool is_full(const Model& model, const State& state, std::size_t hunter) {
  return model.uses_hunger && state.life.full[hunter] > 0;
}

}  // namespace sturnus
