// One step of a flock, in the order in which the papers tell it.
#include "step/step.h"

#include "world/columns.h"
#include "world/state.h"

namespace sturnus {
namespace {

std::array<const float*, 3> pointers(const Columns& columns) {
  std::array<const float*, 3> out{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    out[axis] = columns[axis].empty() ? nullptr : columns[axis].data();
  return out;
}

void fill_flock_bits(const State& state, Scratch& scratch) {
  scratch.flock_bit.resize(state.size());
  for (std::size_t i = 0; i < state.size(); ++i) {
    scratch.flock_bit[i] = state.quarantined[i] != 0 ? 0 : std::uint64_t{1} << state.flock[i];
  }
}

template <int D>
void fill_headings(const State& state, Scratch& scratch, const Workers& workers) {
  fit(scratch.heading, D, state.size());
  workers.for_ranges(state.size(), [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t i = begin; i < end; ++i) put(scratch.heading, i, unit(at<D>(state.velocity, i)));
  });
}

Boids boids_of(const Model& model, const State& state, const Scratch& scratch) {
  Boids boids;
  boids.count = state.size();
  boids.position = pointers(state.position);
  boids.velocity = pointers(state.velocity);
  if (model.uses_headings) boids.heading = pointers(scratch.heading);
  boids.colour = pointers(state.colour);
  boids.id = state.id.data();
  boids.flock = state.flock.data();
  boids.flock_bit = scratch.flock_bit.data();
  return boids;
}

void find_batches(const State& state, Scratch& scratch) {
  if (scratch.index) return scratch.index->batches(scratch.batches);
  scratch.batches.clear();
  cut(0, static_cast<std::uint32_t>(state.size()), scratch.batches);
}

template <int D>
void sum_neighbours(const Model& model, const State& state, Scratch& scratch, const Workers& workers) {
  fill_flock_bits(state, scratch);
  if (model.uses_headings) fill_headings<D>(state, scratch, workers);
  const Boids boids = boids_of(model, state, scratch);
  if (model.uses_totals) population_totals<D>(boids, model.flocks.size(), workers, scratch.totals);
  scratch.sums.resize(state.size() * model.most_rows);
  const NeighbourQuestion question{&model, scratch.index.get(), image_of(model), scratch.totals, state.step};
  find_batches(state, scratch);
  workers.for_ranges(scratch.batches.size(), [&](std::size_t begin, std::size_t end, int) {
    neighbour_sums<D>(boids, std::span(scratch.batches).subspan(begin, end - begin), boids, question,
                      scratch.sums);
  });
}

// Asks the user's rules, and brings accelerations from outside into the order that the boids now have.
void ask_outside(const ScenarioDef& scenario, const State& state, Scratch& scratch, const Outside& outside) {
  scratch.custom.assign(outside.rules.size() + 1, {});
  Columns& external = scratch.custom.front();
  external = outside.external;
  if (external[0].size() == state.size()) reorder(external, scratch.order);
  if (external[0].size() != state.size()) {
    external = {};
    fit(external, state.dimensions, state.size());
  }
  const Columns none;
  const View view(state, scenario, none, none);
  for (std::size_t rule = 0; rule < outside.rules.size(); ++rule) {
    fit(scratch.custom[rule + 1], state.dimensions, state.size());
    Accelerations accelerations(scratch.custom[rule + 1], state.size());
    outside.rules[rule](view, accelerations);
  }
}

}  // namespace

Cloud cloud_of(const Model& model, const State& state) {
  Cloud cloud;
  cloud.dimensions = model.dimensions;
  cloud.count = state.size();
  cloud.position = pointers(state.position);
  cloud.hidden = state.quarantined.data();
  cloud.wraps = model.wraps();
  cloud.min = model.min;
  cloud.max = model.max;
  return cloud;
}

Wrapping image_of(const Model& model) {
  Wrapping image{model.wraps(), model.size, {}};
  for (std::size_t axis = 0; axis < 3; ++axis) image.half[axis] = 0.5f * model.size[axis];
  return image;
}

void sort_by_place(const Model& model, State& state, Scratch& scratch, const Workers& workers) {
  scratch.index.reset();
  scratch.order.clear();
  if (!(model.reach > 0) || state.size() == 0) return;
  const Cloud cloud = cloud_of(model, state);
  scratch.index = make_index(model.index, cloud, model.reach);
  scratch.index->build(cloud, model.reach, workers, scratch.order);
  reorder(state, scratch.order, scratch.spare);
}

void step(const Model& model, const ScenarioDef& scenario, State& state, Scratch& scratch,
          const Outside& outside, const Workers& workers) {
  if (outside.watch != nullptr) outside.watch->begin(Phase::sort, 0);
  quarantine(model, state);
  sort_by_place(model, state, scratch, workers);
  if (outside.watch != nullptr) outside.watch->end(Phase::sort, 0);
  if (outside.watch != nullptr) outside.watch->begin(Phase::neighbours, 0);
  model.dimensions == 3 ? sum_neighbours<3>(model, state, scratch, workers)
                        : sum_neighbours<2>(model, state, scratch, workers);
  ask_outside(scenario, state, scratch, outside);
  if (outside.watch != nullptr) outside.watch->end(Phase::neighbours, 0);
  if (outside.watch != nullptr) outside.watch->begin(Phase::motion, 0);
  combine(model, state, scratch, workers);
  integrate(model, state, scratch, workers);
  if (outside.watch != nullptr) outside.watch->end(Phase::motion, 0);
  ++state.step;
}

}  // namespace sturnus
