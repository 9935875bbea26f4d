// Commands: what people and events do to a world between two steps.
#pragma once

#include <sturnus/view.h>

#include "scenario/model.h"

namespace sturnus {

/// What became of a command.
struct Applied {
  bool is_in_vain = false;       ///< it named a boid that is not there, or found no place for one
  bool has_compiled = false;     ///< the model is a new one
  bool has_moved_boids = false;  ///< some came, went or were put elsewhere
};

/// Carries out a command that has passed `check_command`. A changed scenario compiles a new model.
Applied apply(const Command& command, ScenarioDef& scenario, Model& model, State& state);

/// What of a command of the past, done before that step, is not in the boids that were saved since:
/// parameters, targets, obstacles, the pointer.
Applied redo(const Command& command, std::uint64_t step, ScenarioDef& scenario, Model& model, State& state);

/// Makes the state keep what the model now uses: wander directions and colours appear or go, places are
/// wrapped.
void fit_to_model(const ScenarioDef& scenario, const Model& model, State& state);

}  // namespace sturnus
