// Commands carried out on a world.
#include "world/commands.h"

#include <algorithm>
#include <cmath>

#include "scenario/events.h"
#include "world/columns.h"
#include "world/solids.h"
#include "world/spawn.h"
#include "world/state.h"

namespace sturnus {
namespace {

std::array<float, 3> floats(const Coordinates& at) {
  std::array<float, 3> out{};
  for (std::size_t axis = 0; axis < at.size(); ++axis) out[axis] = static_cast<float>(at[axis]);
  return out;
}

// From a command's place, or the line through it, to another place; in double, by the nearest image.
template <class Reaching>
Place<3> offset_from(const Reaching& command, const Model& model, const std::array<float, 3>& to) {
  Place<3> from;
  std::copy(command.at.begin(), command.at.end(), from.at.begin());
  Place<3> o = way(model, from, place_of<3>(to));
  o.at = beside(o.at, command.along);
  return o;
}

// Of unit length; zero where there is none.
std::array<float, 3> direction_of(const Coordinates& along) {
  double squared = 0;
  for (const double part : along) squared += part * part;
  std::array<float, 3> out{};
  for (std::size_t axis = 0; axis < along.size(); ++axis)
    out[axis] = static_cast<float>(along[axis] / std::sqrt(squared));
  return out;
}

std::array<float, 3> place_in(const Columns& position, std::size_t i) {
  std::array<float, 3> out{};
  for (std::size_t axis = 0; axis < 3 && !position[axis].empty(); ++axis) out[axis] = position[axis][i];
  return out;
}

void erase_obstacles(const Model& model, const EraseBoids& erase, State& state) {
  std::erase_if(state.obstacles, [&](const Obstacle& obstacle) {
    const auto o = offset_from(erase, model, obstacle.at);
    return obstacle.kind != ObstacleKind::plane && dot(o, o) <= erase.radius * erase.radius;
  });
}

float full_speed(const FlockModel& flock, float own_speed) {
  return std::isinf(flock.max_speed) ? own_speed : flock.max_speed;
}

// Away from the place; who is just there keeps his heading.
template <int D>
void scatter_boid(const Model& model, const Place<3>& offset, State& state, std::size_t i) {
  const auto velocity = at<D>(state.velocity, i);
  const Place<3> away = unit(offset);
  Vec<D> direction = unit(velocity);
  for (int axis = 0; axis < D && !(away == Place<3>{}); ++axis)
    direction[axis] = static_cast<float>(away[axis]);
  put(state.velocity, i, direction * full_speed(model.flocks[state.flock[i]], length(velocity)));
}

// What commands do to a state, besides what they do to the scenario.
struct Applier {
  const ScenarioDef& scenario;
  const Model& model;
  State& state;

  Applied operator()(const SetParameter&) const { return {}; }
  Applied operator()(const PlaceTarget&) const { return {}; }

  Applied operator()(const AddBoids& add) const {
    const bool are_all_there = spawn_around(scenario, model, add, state);
    wrap_positions(model, state);
    return {.is_in_vain = !are_all_there, .has_moved_boids = true};
  }

  Applied operator()(const PlaceObstacle& obstacle) const {
    Obstacle sphere;
    sphere.at = floats(obstacle.at);
    sphere.radius = static_cast<float>(obstacle.radius);
    state.obstacles.push_back(sphere);
    wrap_positions(model, state);
    return {};
  }

  Applied operator()(const EraseBoids& erase) const {
    erase_obstacles(model, erase, state);
    std::vector<std::uint8_t> marks(state.size());
    for (std::size_t i = 0; i < state.size(); ++i) {
      const auto o = offset_from(erase, model, place_in(state.position, i));
      marks[i] = dot(o, o) > erase.radius * erase.radius ? 1 : 0;
    }
    keep(state, marks);
    marks.resize(state.food.size());
    for (std::size_t i = 0; i < marks.size(); ++i) {
      const auto o = offset_from(erase, model, place_in(state.food.position, i));
      marks[i] = dot(o, o) > erase.radius * erase.radius ? 1 : 0;
    }
    keep(state.food, marks);
    return {.has_moved_boids = true};
  }

  Applied operator()(const AddFood& add) const {
    spawn_food_around(scenario, model, add, state);
    return {};
  }

  Applied operator()(const MoveBoid& move) const {
    const auto found = std::find(state.id.begin(), state.id.end(), move.id);
    if (found == state.id.end()) return {.is_in_vain = true, .has_moved_boids = true};
    const auto slot = static_cast<std::size_t>(found - state.id.begin());
    const auto old = place_in(state.position, slot);
    for (std::size_t axis = 0; axis < move.to.size(); ++axis) {
      state.position[axis][slot] = static_cast<float>(move.to[axis]);
      state.velocity[axis][slot] = static_cast<float>(move.velocity[axis]);
    }
    state.quarantined[slot] = 0;
    wrap_positions(model, state);
    if (!model.is_solid || bring_out(model, slot, state)) return {.has_moved_boids = true};
    for (std::size_t axis = 0; axis < move.to.size(); ++axis) state.position[axis][slot] = old[axis];
    return {.is_in_vain = true, .has_moved_boids = true};
  }

  Applied operator()(const MovePointer& pointer) const {
    // Released, it has no mode: events write it as "off".
    state.pointer = {pointer.pressed ? pointer.mode : PointerMode::attract, pointer.pressed,
                     floats(pointer.at), direction_of(pointer.along)};
    if (!model.wraps()) return {};
    for (std::size_t axis = 0; axis < pointer.at.size(); ++axis) {
      state.pointer.at[axis] = wrapped(state.pointer.at[axis], model.min[axis], model.max[axis]);
    }
    return {};
  }

  Applied operator()(const ScatterBoids& scatter) const {
    for (std::size_t i = 0; i < state.size(); ++i) {
      const auto o = offset_from(scatter, model, place_in(state.position, i));
      if (dot(o, o) > scatter.radius * scatter.radius || state.quarantined[i] != 0) continue;
      model.dimensions == 3 ? scatter_boid<3>(model, o, state, i) : scatter_boid<2>(model, o, state, i);
    }
    return {};
  }
};

bool keeps_what_it_should(const Model& model, const State& state) {
  return !state.wander[0].empty() == model.uses_wander && !state.colour[0].empty() == model.uses_colour &&
         !state.life.full.empty() == model.uses_hunger && !state.life.jump.empty() == model.uses_jump &&
         !state.life.focus.empty() == model.uses_focus;
}

bool changes(const Command& command, std::uint64_t step, ScenarioDef& scenario, Model& model, State& state) {
  if (!change_scenario(command, step, scenario)) return false;
  model = compile(scenario);
  fit_to_model(scenario, model, state);
  return true;
}

}  // namespace

Applied apply(const Command& command, ScenarioDef& scenario, Model& model, State& state) {
  const bool has_compiled = changes(command, state.step, scenario, model, state);
  Applied applied = std::visit(Applier{scenario, model, state}, command);
  applied.has_compiled = has_compiled;
  return applied;
}

Applied redo(const Command& command, std::uint64_t step, ScenarioDef& scenario, Model& model, State& state) {
  Applied applied;
  applied.has_compiled = changes(command, step, scenario, model, state);
  if (std::holds_alternative<MovePointer>(command) || std::holds_alternative<PlaceObstacle>(command))
    std::visit(Applier{scenario, model, state}, command);
  if (const auto* erase = std::get_if<EraseBoids>(&command)) erase_obstacles(model, *erase, state);
  return applied;
}

void fit_to_model(const ScenarioDef& scenario, const Model& model, State& state) {
  if (state.size() > 0 && !keeps_what_it_should(model, state)) {
    State old = std::move(state);
    state = State{};
    state.dimensions = old.dimensions;
    state.step = old.step;
    state.next_id = old.next_id;
    state.pointer = old.pointer;
    state.obstacles = old.obstacles;
    append_boids(scenario, model, old, -1, state);
  }
  wrap_positions(model, state);
}

}  // namespace sturnus
