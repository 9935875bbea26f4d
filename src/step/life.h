// Eating, starving, births and deaths at the end of a step.
#pragma once

#include <sturnus/simulation.h>

#include "step/step.h"

namespace sturnus {

/// After all have moved: the clocks run on, hunters eat whom they touch, the starved die, food is eaten,
/// boids are born, random food appears. Slots are still those of the step's beginning; afterwards the dead
/// are gone and newborns stand at the end.
void live(const Model& model, const ScenarioDef& scenario, State& state, Scratch& scratch, StepReport& report,
          const Workers& workers);

}  // namespace sturnus
