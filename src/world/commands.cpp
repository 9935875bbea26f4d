// Commands carried out on a world.
#include "world/commands.h"

#include <algorithm>

#include <sturnus/parameters.h>

#include "world/spawn.h"
#include "world/state.h"

namespace sturnus {
namespace {

std::array<float, 3> floats(const Coordinates& at) {
  std::array<float, 3> out{};
  for (std::size_t axis = 0; axis < at.size(); ++axis) out[axis] = static_cast<float>(at[axis]);
  return out;
}

// In double: the offset between places in different images of a wrapped space.
double distance_squared(const Model& model, const State& state, std::size_t i, const Coordinates& at) {
  double sum = 0;
  for (std::size_t axis = 0; axis < at.size(); ++axis) {
    double o = double{state.position[axis][i]} - at[axis];
    const double size = model.size[axis];
    if (model.wraps() && o > size / 2) o -= size;
    if (model.wraps() && o < -size / 2) o += size;
    sum += o * o;
  }
  return sum;
}

struct Applier {
  ScenarioDef& scenario;
  Model& model;
  State& state;

  bool operator()(const SetParameter& set) const {
    if (!set_parameter(scenario, set.path, parse_value(set.value))) return false;
    model = compile(scenario);
    fit_to_model(scenario, model, state);
    return true;
  }

  bool operator()(const AddBoids& add) const {
    spawn_around(scenario, model, add, state);
    wrap_positions(model, state);
    return true;
  }

  bool operator()(const EraseBoids& erase) const {
    std::vector<std::uint8_t> marks(state.size());
    for (std::size_t i = 0; i < state.size(); ++i) {
      marks[i] = distance_squared(model, state, i, erase.at) > erase.radius * erase.radius ? 1 : 0;
    }
    keep(state, marks);
    return true;
  }

  bool operator()(const MoveBoid& move) const {
    const auto found = std::find(state.id.begin(), state.id.end(), move.id);
    if (found == state.id.end()) return false;
    const auto slot = static_cast<std::size_t>(found - state.id.begin());
    for (std::size_t axis = 0; axis < move.to.size(); ++axis) {
      state.position[axis][slot] = static_cast<float>(move.to[axis]);
      state.velocity[axis][slot] = static_cast<float>(move.velocity[axis]);
    }
    state.quarantined[slot] = 0;
    wrap_positions(model, state);
    return true;
  }

  bool operator()(const MovePointer& pointer) const {
    // Released, it has no mode: events write it as "off".
    state.pointer = {pointer.pressed ? pointer.mode : PointerMode::attract, pointer.pressed,
                     floats(pointer.at)};
    if (!model.wraps()) return true;
    for (std::size_t axis = 0; axis < pointer.at.size(); ++axis) {
      state.pointer.at[axis] = wrapped(state.pointer.at[axis], model.min[axis], model.max[axis]);
    }
    return true;
  }
};

}  // namespace

bool apply(const Command& command, ScenarioDef& scenario, Model& model, State& state) {
  return std::visit(Applier{scenario, model, state}, command);
}

void fit_to_model(const ScenarioDef& scenario, const Model& model, State& state) {
  const bool keeps_wander = !state.wander[0].empty();
  const bool keeps_colour = !state.colour[0].empty();
  if (state.size() > 0 && (keeps_wander != model.uses_wander || keeps_colour != model.uses_colour)) {
    State old = std::move(state);
    state = State{};
    state.dimensions = old.dimensions;
    state.step = old.step;
    state.next_id = old.next_id;
    state.pointer = old.pointer;
    append_boids(scenario, model, old, -1, state);
  }
  wrap_positions(model, state);
}

}  // namespace sturnus
