// Working memory of a step: may be thrown away or filled with garbage before any step without changing one
// bit.
#pragma once

#include <sturnus/simulation.h>

#include "neighbours/kernel.h"
#include "world/state.h"

namespace sturnus {

struct Scratch {
  std::unique_ptr<NeighbourIndex> index;
  std::vector<std::uint32_t> order;  ///< where each boid stood before the index sorted them
  Spare spare;
  std::vector<std::uint64_t> flock_bit;  ///< 1 << flock, 0 for the quarantined
  Columns heading;
  std::vector<Totals> totals;
  std::vector<Span> batches;  ///< of boids that are steered at once
  std::vector<NeighbourSum> sums;
  Columns acceleration;  ///< with the boundary's turn, before the time step
  Columns next_colour;
  std::vector<Columns> custom;                   ///< what each user rule asks for
  Columns previous_position, previous_velocity;  ///< before the last step, for observers
};

/// What acts on a step besides the model: rules of the user's own, accelerations from outside;
/// and who looks on.
struct Outside {
  std::vector<Rule> rules;
  Columns external;  ///< empty, or one value for each boid in the order before the step
  StepWatch* watch = nullptr;
};

/// Makes the columns of as many axes hold `size` values.
void fit(Columns& columns, int axes, std::size_t size);

/// Fills every array with bytes 0xFF and forgets the index.
void poison(Scratch& scratch);

}  // namespace sturnus
