// Working memory of a step: may be thrown away or filled with garbage before any step without changing one
// bit.
#pragma once

#include <sturnus/simulation.h>

#include "neighbours/kernel.h"
#include "neighbours/passes.h"
#include "neighbours/pieces.h"
#include "world/obstacle_index.h"
#include "world/state.h"

namespace sturnus {

/// Of one part of the work.
struct PartScratch {
  KernelScratch kernel;
  SumBlock sums;
  std::vector<std::uint32_t> fallen;                ///< boids that went bad in this step
  std::vector<std::uint32_t> eaters;                ///< slots of those who touch food
  ObstacleColumns block_obstacles, near_obstacles;  ///< near the boids at hand
  bool has_many_obstacles = false;                  ///< near the block: lanes have none, boids ask the index
  bool asks_obstacles = false;                      ///< the same of the group at hand
  std::vector<std::uint32_t> lanes_of_obstacles;    ///< who may feel each of them
  std::vector<std::uint32_t> felt_obstacles;        ///< by one boid
  std::vector<Pieces::Run> food_runs;               ///< near the boids at hand
  float longest = 0;                                ///< length; the longest way of those looked at
};

/// Those who hunt, in the order of storage, and where each is pulled.
struct Hunters {
  std::vector<std::uint32_t> slots;
  Columns pull;
};

/// A piece of food that was eaten.
struct Meal {
  std::array<float, 3> place, eater;  ///< where it lay, and where its eater stands
  std::size_t flock = 0;              ///< of the eater
};

/// What births and deaths are worked out in.
struct LifeScratch {
  std::vector<std::uint8_t> alive, uneaten;  ///< of boids, of pieces
  std::vector<std::uint8_t> touches;         ///< of those who may eat
  std::vector<std::uint32_t> eaters;         ///< slots of those who eat, by id
  std::vector<std::size_t> members;          ///< of each flock
  std::vector<Meal> meals;                   ///< in order of the eaters' ids
};

struct Scratch {
  std::unique_ptr<NeighbourIndex> index;
  Index indexed_as;                             ///< what `index` is
  std::unique_ptr<NeighbourIndex> other_index;  ///< of a world that was smaller or larger
  Index other_indexed_as;
  std::size_t room = 0;     ///< boids that there is memory for in a world with births; 0: nobody has looked
  bool is_indexed = false;  ///< false where nobody has a finite reach
  std::vector<std::uint32_t> order;  ///< where each boid stood before the index sorted them
  Spare spare;
  Columns heading;
  std::vector<std::array<float, 3>> targets;  ///< where they are in this step
  std::vector<Totals> totals, total_parts;
  Passes passes;
  std::vector<std::uint32_t> watched;  ///< slots of those in play whose flocks are looked at, by id
  std::vector<Stretch> stretches;      ///< of boids, where there are several flocks
  std::vector<Span> batches;           ///< of boids that are steered at once
  std::vector<std::uint64_t> weights;  ///< of blocks of batches, added up
  std::vector<PartScratch> parts;
  ObstacleIndex obstacles;
  Columns next_colour;
  std::vector<Columns> custom;  ///< what each user rule asks for; empty: nothing
  Hunters hunters;
  Pieces pieces;
  LifeScratch life;
  /// Before the last step, for observers; during a step, where boids go.
  Columns previous_position, previous_velocity;
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
