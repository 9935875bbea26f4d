// Memory for a world that grows by births.
#pragma once

#include "step/scratch.h"

namespace sturnus {

/// Makes the state and a step's arrays hold so many boids, and all food that may come by itself, without
/// asking for memory. `parts` is how many parts the work is done in.
void reserve(State& state, Scratch& scratch, const Model& model, std::size_t boids, std::size_t parts);

}  // namespace sturnus
