// One step of a flock, in the order in which the papers tell it.
#include "step/step.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "step/life.h"
#include "step/room.h"
#include "step/watched.h"
#include "world/columns.h"
#include "world/spawn.h"
#include "world/state.h"

namespace sturnus {
namespace {

// Asks the user's rules, and brings accelerations from outside into the order that the boids now have.
void ask_outside(const ScenarioDef& scenario, const State& state, Scratch& scratch, const Outside& outside,
                 const Workers& workers) {
  scratch.custom.resize(outside.rules.size() + 1);
  Columns& external = scratch.custom.front();
  external = outside.external;
  if (external[0].size() == state.size()) reorder(external, scratch.order, scratch.spare.floats, workers);
  if (external[0].size() != state.size()) external = {};
  const Columns none;
  const View view(state, scenario, none, none);
  for (std::size_t rule = 0; rule < outside.rules.size(); ++rule) {
    Columns& asked = scratch.custom[rule + 1];
    for (auto& column : asked) column.clear();
    fit(asked, state.dimensions, state.size());
    Accelerations accelerations(asked, state.size());
    outside.rules[rule](view, accelerations);
  }
}

// Who is looked at by name, by everybody who does.
void find_watched(const Model& model, const State& state, Scratch& scratch) {
  scratch.watched.clear();
  for (std::size_t i = 0; model.watched != 0 && i < state.size(); ++i) {
    if ((model.watched >> state.flock[i] & 1u) != 0 && state.quarantined[i] == 0)
      scratch.watched.push_back(static_cast<std::uint32_t>(i));
  }
  std::sort(scratch.watched.begin(), scratch.watched.end(),
            [&](std::uint32_t a, std::uint32_t b) { return state.id[a] < state.id[b]; });
}

bool is_the_same(const Index& one, const Index& other) {
  return one.kind == other.kind && one.leaf_size == other.leaf_size && one.depth_limit == other.depth_limit;
}

// Rows of cells in one reach, so that whole cells fill most of it; by measurement. In great crowds the boids
// at the rim and the rows of cells then grow alike; a clump that lies within the smallest radius has no rim,
// and a few rows tell its shape. `share`: the smallest radius as a part of the reach.
int fineness_for(int dimensions, const Crowd& crowd, double share) {
  const double clumps_in_reach = crowd.density / static_cast<double>(crowd.boids);
  const double in_clump = dimensions == 3 ? 3 * std::cbrt(clumps_in_reach) : 8 * std::sqrt(clumps_in_reach);
  const bool has_rim = clumps_in_reach * std::pow(share, dimensions) < 1;
  const double most = has_rim ? 4096 : std::clamp(in_clump, dimensions == 3 ? 5.0 : 12.0, 4096.0);
  const double seen = std::min(crowd.density, static_cast<double>(crowd.boids));
  const double more = std::max(1.0, crowd.density / 10'000);
  if (dimensions == 3) return seen < 5000 ? 3 : static_cast<int>(std::min(most, 5 * std::cbrt(more)));
  if (seen < 6000) return seen < 2000 ? 4 : 6;
  return static_cast<int>(std::min(most, 12 * std::sqrt(more)));
}

// So few that cells cost more than looking at everybody; by measurement.
bool is_small(const Index& wanted, const Cloud& cloud) {
  const std::size_t few = cloud.dimensions == 3 ? 320 : 128;
  return wanted.kind == IndexKind::grid && wanted.path != SumPath::dense && cloud.count <= few;
}

// Keeps the index of the step before, with its memory, where it still fits; and one more, for a world whose
// size goes up and down.
void fit_index(const Model& model, const Cloud& cloud, Scratch& scratch) {
  Index wanted = model.index;
  if (!may_divide(cloud, model.reach) || is_small(wanted, cloud)) wanted.kind = IndexKind::all_pairs;
  if (scratch.index && is_the_same(scratch.indexed_as, wanted)) return;
  std::swap(scratch.index, scratch.other_index);
  std::swap(scratch.indexed_as, scratch.other_indexed_as);
  if (scratch.index && is_the_same(scratch.indexed_as, wanted)) return;
  scratch.index = make_index(wanted, cloud, model.reach);
  scratch.indexed_as = wanted;
}

// Memory for all that births may bring, so that no step asks for it: for the arrays of the state, for those
// that change places with them, for the index that a world of that size has.
void make_room_for_births(const Model& model, State& state, Scratch& scratch, const Workers& workers) {
  const auto parts = static_cast<std::size_t>(workers.count());
  scratch.room = most_after_births(model, state);
  reserve(state, scratch, model, scratch.room, parts);
  if (!(model.reach > 0)) return;
  Cloud cloud = cloud_of(model, state);
  for (const std::size_t count : {scratch.room, state.size()}) {
    cloud.count = count;
    fit_index(model, cloud, scratch);
    scratch.index->reserve(scratch.room, parts);
  }
}

}  // namespace

Cloud cloud_of(const Model& model, const State& state) {
  Cloud cloud;
  cloud.dimensions = model.dimensions;
  cloud.count = state.size();
  cloud.position = pointers(state.position);
  cloud.hidden = state.quarantined.data();
  cloud.hides = is_any_hidden(state);
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

namespace {

double least_reach(const Passes& passes) {
  float least = std::numeric_limits<float>::infinity();
  for (const SumPass& pass : passes.all()) least = std::min(least, pass.reach);
  return double{least};
}

// Plans by how crowded cells are. Dense passes want finer ones, which may tell of a clump that is denser
// still.
void plan_passes(const Model& model, Cloud cloud, Scratch& scratch, const Workers& workers) {
  for (Crowd crowd{0, cloud.count};;) {
    crowd.density = std::max(crowd.density, scratch.index->crowding());
    scratch.passes.plan(model, is_wide_in_use(), crowd);
    const int wanted =
        fineness_for(model.dimensions, crowd, least_reach(scratch.passes) / double{model.reach});
    const bool uses_cells = scratch.passes.has_dense() && scratch.index->layout().rows > 0;
    if (!uses_cells || wanted < 2 * cloud.fineness) return;
    cloud.fineness = wanted;
    scratch.index->build(cloud, model.reach, workers, scratch.order);
  }
}

}  // namespace

void sort_by_place(const Model& model, State& state, Scratch& scratch, const Workers& workers) {
  scratch.order.clear();
  scratch.is_indexed = model.reach > 0 && state.size() > 0;
  if (!scratch.is_indexed) return scratch.passes.plan(model, is_wide_in_use());
  const Cloud cloud = cloud_of(model, state);
  fit_index(model, cloud, scratch);
  scratch.index->build(cloud, model.reach, workers, scratch.order);
  plan_passes(model, cloud, scratch, workers);
  reorder(state, scratch.order, scratch.spare, workers);
}

void prepare(const Model& model, const ScenarioDef& scenario, State& state, Scratch& scratch,
             const Outside& outside, const Workers& workers) {
  quarantine(model, state, workers);
  sort_by_place(model, state, scratch, workers);
  find_watched(model, state, scratch);
  scratch.obstacles.fit(model, state.obstacles, model.obstacle_reach);
  ask_outside(scenario, state, scratch, outside, workers);
  look_around(model, state, scratch, workers);
}

void step(const Model& model, const ScenarioDef& scenario, State& state, Scratch& scratch,
          const Outside& outside, StepReport& report, const Workers& workers) {
  {
    const Watched watched(outside.watch, Phase::sort, 0);
    if (model.has_feeders && scratch.room == 0) make_room_for_births(model, state, scratch, workers);
    prepare(model, scenario, state, scratch, outside, workers);
  }
  flock(model, state, scratch, outside.watch, workers);
  const Watched watched(outside.watch, Phase::motion, 0);
  live(model, scenario, state, scratch, report, workers);
  ++state.step;
}

}  // namespace sturnus
