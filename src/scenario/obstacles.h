// Obstacles from their definitions, back to definitions, and what can be wrong with them.
#pragma once

#include <sturnus/scenario.h>

namespace sturnus {

/// The obstacles at the start of a run, or the problem with random ones that find no room. The lists must
/// have passed `obstacle_problems`.
Result<std::vector<Obstacle>> obstacles_of(const ScenarioDef& scenario);

/// Definitions from which `obstacles_of` makes these very obstacles, in their order.
std::vector<ObstacleDef> definitions_of(const std::vector<Obstacle>& obstacles, int dimensions);

/// Everything that is wrong with a scenario's obstacles.
Problems obstacle_problems(const ScenarioDef& scenario);

/// The sentence for a sphere that can't be an obstacle; empty when it can.
std::optional<std::string> check_sphere_radius(const ScenarioDef& scenario, double radius);

}  // namespace sturnus
