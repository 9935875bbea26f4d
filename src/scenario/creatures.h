// Hunters, their prey and their food: compiled, and what can be wrong with them.
#pragma once

#include "scenario/model.h"

namespace sturnus {

/// Fills in what a flock hunts, how it jumps, starves and feeds, with the terms of it.
void compile_creature(const ScenarioDef& scenario, std::size_t own, FlockModel& out);

/// The kinds of food, and which clocks the state keeps.
void compile_life(const ScenarioDef& scenario, Model& model);

/// How many boids of a flock there may be after births.
std::int64_t population_cap(const FlockDef& flock);

/// Appends what is wrong with them.
void check_creatures(const ScenarioDef& scenario, Problems& problems);

}  // namespace sturnus
