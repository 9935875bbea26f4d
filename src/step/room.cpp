// Memory for a world that grows by births.
#include "step/room.h"

#include <algorithm>

namespace sturnus {
namespace {

// A batch's neighbourhood is told in spans, a few for each row of cells.
constexpr std::size_t many_spans = 1024;
constexpr std::size_t very_many = 1 << 16;
constexpr std::size_t boids_in_block = 64 * batch_size;

void reserve(Columns& columns, int axes, std::size_t size) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(axes); ++axis) columns[axis].reserve(size);
}

// Boids' arrays, and those that change places with them; the ones that are not in use stay empty.
void reserve_state(State& state, Scratch& scratch, const Model& model, std::size_t boids) {
  for_each_array(state, [boids](auto& array) {
    if (!array.empty()) array.reserve(boids);
  });
  for (Columns* columns : {&scratch.previous_position, &scratch.previous_velocity})
    reserve(*columns, model.dimensions, boids);
  if (model.uses_headings) reserve(scratch.heading, model.dimensions, boids);
  if (model.uses_colour) reserve(scratch.next_colour, 3, boids);
  scratch.spare.ids.reserve(boids);
  scratch.spare.bytes.reserve(boids);
  scratch.spare.floats.reserve(boids);
  if (model.uses_hunger || model.uses_jump) scratch.spare.doubles.reserve(boids);
}

void reserve_food(Food& food, int dimensions, std::size_t pieces) {
  food.id.reserve(pieces);
  food.kind.reserve(pieces);
  reserve(food.position, dimensions, pieces);
}

void reserve_life(LifeScratch& life, std::size_t boids, std::size_t pieces) {
  life.alive.reserve(boids);
  life.uneaten.reserve(pieces);
  life.touches.reserve(boids);
  life.eaters.reserve(boids);
  life.meals.reserve(std::min(boids, pieces));
}

void reserve_part(PartScratch& part, const Model& model, std::size_t boids, std::size_t pieces) {
  part.kernel.spans.reserve(many_spans);
  part.eaters.reserve(boids);
  part.food_runs.reserve(pieces);
  part.sums.fit(model.most_rows, 0, std::min(boids, boids_in_block));
}

// As far as they come by themselves; where that is very many, memory is asked for as they come.
std::size_t most_pieces(const Model& model, const State& state) {
  std::size_t most = state.food.size();
  for (const FoodModel& food : model.food) most += food.every > 0 ? std::min(food.most, very_many) : 0;
  return most;
}

}  // namespace

void reserve(State& state, Scratch& scratch, const Model& model, std::size_t boids, std::size_t parts) {
  const std::size_t pieces = most_pieces(model, state);
  reserve_state(state, scratch, model, boids);
  reserve_food(state.food, model.dimensions, pieces);
  reserve_life(scratch.life, boids, pieces);
  scratch.life.members.reserve(model.flocks.size());
  scratch.pieces.reserve(pieces);
  scratch.order.reserve(boids);
  scratch.batches.reserve(boids);
  scratch.weights.reserve(boids / batch_size + 1);
  scratch.stretches.reserve(boids / batch_size + 2);
  if (model.watched != 0) scratch.watched.reserve(boids);
  scratch.parts.resize(parts);
  for (PartScratch& part : scratch.parts) reserve_part(part, model, boids, pieces);
}

}  // namespace sturnus
