// Working memory of a step.
#include "step/scratch.h"

#include <cstring>

namespace sturnus {
namespace {

template <class T>
void spoil(std::vector<T>& array) {
  if (!array.empty()) std::memset(static_cast<void*>(array.data()), 0xff, array.size() * sizeof(T));
}

void spoil(Columns& columns) {
  for (auto& column : columns) spoil(column);
}

}  // namespace

void fit(Columns& columns, int axes, std::size_t size) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(axes); ++axis) columns[axis].resize(size);
}

void poison(Scratch& scratch) {
  scratch.index.reset();
  scratch.other_index.reset();
  scratch.room = 0;
  scratch.is_indexed = false;
  scratch.obstacles.forget();
  spoil(scratch.order);
  spoil(scratch.spare.ids);
  spoil(scratch.spare.bytes);
  spoil(scratch.spare.floats);
  spoil(scratch.targets);
  spoil(scratch.totals);
  spoil(scratch.total_parts);
  spoil(scratch.watched);
  spoil(scratch.stretches);
  spoil(scratch.batches);
  spoil(scratch.weights);
  for (PartScratch& part : scratch.parts) {
    spoil(part.kernel.spans);
    spoil(part.fallen);
    spoil(part.eaters);
    spoil(part.lanes_of_obstacles);
    spoil(part.felt_obstacles);
    spoil(part.food_runs);
    part.block_obstacles.spoil();
    part.near_obstacles.spoil();
    part.sums.spoil();
  }
  for (Columns& columns : scratch.custom) spoil(columns);
  scratch.pieces.spoil();
  spoil(scratch.spare.doubles);
  spoil(scratch.hunters.slots);
  spoil(scratch.hunters.pull);
  spoil(scratch.life.alive);
  spoil(scratch.life.uneaten);
  spoil(scratch.life.touches);
  spoil(scratch.life.eaters);
  spoil(scratch.life.members);
  spoil(scratch.life.meals);
  for (Columns* columns :
       {&scratch.heading, &scratch.next_colour, &scratch.previous_position, &scratch.previous_velocity}) {
    spoil(*columns);
  }
}

}  // namespace sturnus
