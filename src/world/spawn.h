// New boids: at the start of a run and by hand, all from counter-based random numbers.
#pragma once

#include <sturnus/view.h>

#include "scenario/model.h"
#include "world/obstacle_index.h"

namespace sturnus {

/// Appends `flock.count` boids as the flock's start says, outside of the state's obstacles. Returns how many
/// found no such place and stand inside.
std::int64_t spawn_flock(const ScenarioDef& scenario, const Model& model, std::size_t flock, State& state);

/// Appends boids around a place as AddBoids says, outside of obstacles where there is such a place; in a
/// solid world nowhere else. False when somebody found none and did not come.
bool spawn_around(const ScenarioDef& scenario, const Model& model, const AddBoids& add, State& state);

/// Brings a boid that was put somewhere to the nearest free place of a solid world; false where none is
/// found.
bool bring_out(const Model& model, std::size_t slot, State& state);

/// Appends a boid of the flock that appears at `distance` (length) from a place, in a random direction; its
/// heading and speed are those of a start.
void spawn_beside(const ScenarioDef& scenario, const Model& model, std::size_t flock,
                  const std::array<float, 3>& place, float distance, State& state);

/// Appends `count` pieces of a kind of food, where its definition says; where obstacles are solid, outside of
/// those in the index. A piece that finds no place does not come.
void spawn_food(const ScenarioDef& scenario, const Model& model, std::size_t kind, std::size_t count,
                const ObstacleIndex& obstacles, State& state);

/// The same for the food with which a world begins.
void spawn_food(const ScenarioDef& scenario, const Model& model, State& state);

/// Appends pieces of food around a place as AddFood says.
void spawn_food_around(const ScenarioDef& scenario, const Model& model, const AddFood& add, State& state);

/// How many boids there may be at a time by births.
std::size_t most_after_births(const Model& model, const State& state);

/// Appends the boids of another state that belong to `flock`; all flocks, and the food, when it is -1. Ids
/// that are taken are replaced by new ones; wander, colour and clocks are filled in where the other state
/// lacks them.
void append_boids(const ScenarioDef& scenario, const Model& model, const State& from, int flock,
                  State& state);

/// Brings every boid and the middle of every obstacle into a wrapped space.
void wrap_positions(const Model& model, State& state);

}  // namespace sturnus
