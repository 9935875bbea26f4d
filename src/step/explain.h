// What one boid would feel in the next step, told term by term.
#pragma once

#include <sturnus/explain.h>

#include "step/step.h"

namespace sturnus {

/// The constant part of a run that is explained.
struct Explained {
  const Model& model;
  const ScenarioDef& scenario;
  const Outside& outside;
  const std::vector<std::string>& rules;  ///< names, in the order of the custom terms' rows
};

/// Works on a copy of the state: sorts it as the step would, and sums over the neighbours of one batch.
Result<Explanation> explain(const Explained& explained, const State& state, std::uint64_t id,
                            const Workers& workers);

}  // namespace sturnus
