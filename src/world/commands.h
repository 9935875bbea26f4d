// Commands: what people and events do to a world between two steps.
#pragma once

#include <sturnus/view.h>

#include "scenario/model.h"

namespace sturnus {

/// Carries out a command that has passed `check_command`. A changed parameter compiles a new model. Returns
/// false when the command named a boid that is not there.
bool apply(const Command& command, ScenarioDef& scenario, Model& model, State& state);

/// Makes the state keep what the model now uses: wander directions and colours appear or go, places are
/// wrapped.
void fit_to_model(const ScenarioDef& scenario, const Model& model, State& state);

}  // namespace sturnus
