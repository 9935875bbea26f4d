// New boids: at the start of a run and by hand, all from counter-based random numbers.
#pragma once

#include <sturnus/view.h>

#include "scenario/model.h"

namespace sturnus {

/// Appends `flock.count` boids as the flock's start says, outside of the state's obstacles. Returns how many
/// found no such place and stand inside.
std::int64_t spawn_flock(const ScenarioDef& scenario, const Model& model, std::size_t flock, State& state);

/// Appends boids around a place as AddBoids says, outside of obstacles where there is such a place.
void spawn_around(const ScenarioDef& scenario, const Model& model, const AddBoids& add, State& state);

/// Appends the boids of another state that belong to `flock`; all flocks when it is -1. Ids that are taken
/// are replaced by new ones; wander and colour are filled in where the other state lacks them.
void append_boids(const ScenarioDef& scenario, const Model& model, const State& from, int flock,
                  State& state);

/// Brings every boid and the middle of every obstacle into a wrapped space.
void wrap_positions(const Model& model, State& state);

}  // namespace sturnus
