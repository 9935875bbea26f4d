// Targets: where they are, and how they come and go.
#pragma once

#include "scenario/model.h"

namespace sturnus {

/// Where the targets are before a step, in the space.
void place_targets(const Model& model, std::uint64_t step, std::vector<std::array<float, 3>>& places);

/// Puts a target into the scenario, under the next free name.
void add_target(const PlaceTarget& placed, ScenarioDef& scenario);

/// Takes those out that are within reach before that step; tells whether there were any.
bool erase_targets(const EraseBoids& erase, std::uint64_t step, ScenarioDef& scenario);

}  // namespace sturnus
