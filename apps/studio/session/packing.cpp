// Packing boids into instances.
#include "session/packing.h"

#include <algorithm>
#include <cmath>

namespace studio {
namespace {

using sturnus::State;
using sturnus::View;

// The scenario's flocks as flags: what is the same for all of a flock's boids.
struct FlockFacts {
  bool hunts = false;
  bool jumps = false;
  double starves_after = sturnus::infinity;
};

std::vector<FlockFacts> facts_of(const sturnus::ScenarioDef& scenario) {
  std::vector<FlockFacts> facts;
  for (const sturnus::FlockDef& flock : scenario.flocks) {
    facts.push_back({flock.hunt.has_value(), flock.jump && flock.jump->on,
                     flock.hunger ? flock.hunger->starves_after : sturnus::infinity});
  }
  return facts;
}

std::uint8_t byte(double share) {
  return static_cast<std::uint8_t>(std::clamp(share, 0.0, 1.0) * 255 + 0.5);
}

void pack_life(const State& state, const FlockFacts& facts, std::size_t slot, Instance& boid) {
  if (!facts.hunts) return;
  boid.flags |= is_hunter;
  const sturnus::Life& life = state.life;
  if (!life.full.empty() && life.full[slot] > 0) boid.flags |= is_full;
  if (!life.jump.empty() && life.jump[slot] > 0) boid.flags |= is_jumping;
  const bool rests = !life.rest.empty() && life.rest[slot] > 0;
  if (facts.jumps && !rests && (boid.flags & is_jumping) == 0) boid.flags |= can_jump;
  if (!life.fasting.empty() && std::isfinite(facts.starves_after))
    boid.starving = byte(life.fasting[slot] / facts.starves_after);
}

// Moves a previous place to the near side of the seam.
void bring_near(const sturnus::Extent& extent, Instance& boid) {
  for (std::size_t axis = 0; axis < extent.min.size(); ++axis) {
    const auto side = static_cast<float>(extent.max[axis] - extent.min[axis]);
    const float moved = boid.position[axis] - boid.previous[axis];
    if (moved > side / 2) boid.previous[axis] += side;
    if (moved < -side / 2) boid.previous[axis] -= side;
  }
}

void pack_boids(const View& view, Frame& frame) {
  const State& state = view.state();
  const std::vector<FlockFacts> facts = facts_of(view.scenario());
  const bool wraps = view.scenario().space.boundary.kind == sturnus::BoundaryKind::wrap;
  frame.has_previous = view.has_previous();
  frame.boids.resize(state.size());
  frame.ids = state.id;
  for (std::size_t slot = 0; slot < state.size(); ++slot) {
    Instance boid;
    const auto position = view.position(slot), velocity = view.velocity(slot);
    const auto previous = frame.has_previous ? view.previous_position(slot) : position;
    std::copy(position.begin(), position.end(), boid.position);
    std::copy(previous.begin(), previous.end(), boid.previous);
    std::copy(velocity.begin(), velocity.end(), boid.velocity);
    if (wraps) bring_near(frame.extent, boid);
    boid.flock = state.flock[slot];
    boid.id = static_cast<std::uint32_t>(state.id[slot]);
    if (state.quarantined[slot] != 0) boid.flags |= is_quarantined;
    pack_life(state, facts[boid.flock], slot, boid);
    if (!state.colour[0].empty()) {
      for (std::size_t channel = 0; channel < 3; ++channel)
        boid.colour[channel] = byte(double{state.colour[channel][slot]});
      boid.colour[3] = 255;
    }
    frame.boids[slot] = boid;
  }
}

// Where most are: the mean place, or the middle of the space when there is nobody.
void pack_centre(Frame& frame) {
  std::array<double, 3> sum{};
  for (const Instance& boid : frame.boids) {
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += double{boid.position[axis]};
  }
  const auto count = static_cast<double>(frame.boids.size());
  frame.centre = {};
  for (std::size_t axis = 0; axis < frame.extent.min.size(); ++axis) {
    const double middle = (frame.extent.min[axis] + frame.extent.max[axis]) / 2;
    frame.centre[axis] = static_cast<float>(frame.boids.empty() ? middle : sum[axis] / count);
  }
}

void pack_food(const View& view, Frame& frame) {
  const sturnus::Food& food = view.state().food;
  frame.food.resize(food.size());
  for (std::size_t i = 0; i < food.size(); ++i) {
    Piece& piece = frame.food[i];
    for (std::size_t axis = 0; axis < 3; ++axis)
      piece.position[axis] = food.position[axis].empty() ? 0 : food.position[axis][i];
    piece.kind = food.kind[i];
    piece.size = static_cast<float>(view.scenario().food[food.kind[i]].size);
  }
}

void pack_targets(const sturnus::Simulation& simulation, Frame& frame) {
  const auto places = simulation.target_places();
  const auto& targets = simulation.scenario().targets;
  frame.targets.clear();
  for (std::size_t i = 0; i < places.size(); ++i) {
    frame.targets.push_back(
        {places[i], targets[i].kind == sturnus::TargetKind::repel, static_cast<float>(targets[i].radius)});
  }
}

}  // namespace

void pack(const sturnus::Simulation& simulation, Frame& frame) {
  const View view = simulation.view();
  frame.step = simulation.step_number();
  frame.dimensions = view.dimensions();
  frame.extent = sturnus::extent_of(simulation.scenario());
  frame.obstacles = view.state().obstacles;
  frame.pointer = view.state().pointer;
  pack_boids(view, frame);
  pack_centre(frame);
  pack_food(view, frame);
  pack_targets(simulation, frame);
  frame.population.assign(view.scenario().flocks.size(), 0);
  for (const Instance& boid : frame.boids) ++frame.population[boid.flock];
}

}  // namespace studio
