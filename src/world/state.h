// Work on whole states: every array at once, the hash, the order of storage.
#pragma once

#include <sturnus/view.h>

#include <cmath>

#include "base/workers.h"

namespace sturnus {

/// Calls f(array) for every clock of the boids' lives.
template <class AnyLife, class F>
void for_each_clock(AnyLife& life, F&& f) {
  for (auto* clock : {&life.full, &life.fasting, &life.jump, &life.rest}) f(*clock);
}

/// Calls f(array) for every per-boid array, of whatever type.
template <class AnyState, class F>
void for_each_array(AnyState& state, F&& f) {
  f(state.id);
  f(state.flock);
  f(state.quarantined);
  for (auto* columns : {&state.position, &state.velocity, &state.wander, &state.colour}) {
    for (auto& column : *columns) f(column);
  }
  for_each_clock(state.life, f);
  f(state.life.focus);
}

/// Wrapped sum over all boids of a mix of their values, plus the rest: covers every array and does not depend
/// on the order of storage.
std::uint64_t hash(const State& state);

/// Memory that reordering works in, kept so that it need not be asked for in every step.
struct Spare {
  std::vector<std::uint64_t> ids;
  std::vector<std::uint8_t> bytes;
  std::vector<float> floats;
  std::vector<double> doubles;
};

/// Puts boid order[i] at place i. `order` is a permutation, or empty for "as it is".
void reorder(State& state, const std::vector<std::uint32_t>& order, Spare& spare, const Workers& workers);
/// The same for arrays beside the state; empty ones stay empty.
void reorder(Columns& columns, const std::vector<std::uint32_t>& order, std::vector<float>& spare,
             const Workers& workers);

/// Keeps the boids whose mark is not 0, in their order.
void keep(State& state, const std::vector<std::uint8_t>& marks);
void keep(Columns& columns, const std::vector<std::uint8_t>& marks);
void keep(Food& food, const std::vector<std::uint8_t>& marks);

/// Whether some boid is out of play.
bool is_any_hidden(const State& state);

/// A number that a step may compute with: finite, and not beyond 1e15.
inline bool is_sound(float value) {
  return std::abs(value) <= 1e15f;
}

/// Wraps a coordinate into [min, max) of a space of that size by floored modulo; exactly max becomes min.
/// What is not sound stays as it is, for the quarantine to see.
float wrapped_from_outside(float coordinate, float min, float max);
inline float wrapped(float coordinate, float min, float max) {
  return coordinate >= min && coordinate < max ? coordinate : wrapped_from_outside(coordinate, min, max);
}

/// Brings the centres of spheres and boxes into a wrapped space with these corners.
void wrap_obstacles(State& state, const std::array<float, 3>& min, const std::array<float, 3>& max);

/// Bytes that a run of that many boids needs, and bytes that the machine has to give.
double bytes_needed(double boids);
double bytes_available();

}  // namespace sturnus
