// What the studio's tests share: a window in memory, and frames made of a simulation.
#pragma once

#include <gtest/gtest.h>
#include <sturnus/sturnus.h>

#include <cmath>
#include <cstdlib>
#include <memory>

#include "session/frame.h"
#include "view/view.h"
#include "window.h"

namespace studio::testing_support {

/// A window without any display; nothing where there is no OpenGL.
inline std::unique_ptr<Window> offscreen(sturnus::Size size) {
  setenv("SDL_VIDEODRIVER", "offscreen", 1);
  auto window = Window::open("test", size, false);
  if (!window) return nullptr;
  return std::make_unique<Window>(std::move(*window));
}

inline std::uint8_t byte_of(float part) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0f, 1.0f) * 255));
}

inline Instance instance_of(const sturnus::View& view, std::size_t slot, const sturnus::Extent& extent) {
  Instance out{};
  const auto at = view.position(slot), velocity = view.velocity(slot);
  const auto before = view.has_previous() ? view.previous_position(slot) : at;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    out.position[axis] = at[axis];
    out.previous[axis] = before[axis];
    out.velocity[axis] = velocity[axis];
    if (axis >= extent.min.size()) continue;
    const auto side = static_cast<float>(extent.max[axis] - extent.min[axis]);
    if (view.scenario().space.boundary.kind == sturnus::BoundaryKind::wrap)
      out.previous[axis] += side * std::round((at[axis] - before[axis]) / side);
  }
  const sturnus::State& state = view.state();
  out.flock = state.flock[slot];
  out.id = static_cast<std::uint32_t>(state.id[slot]);
  const sturnus::FlockDef& flock = view.scenario().flocks[out.flock];
  if (flock.hunt) out.flags |= is_hunter;
  if (!state.life.full.empty() && state.life.full[slot] > 0) out.flags |= is_full;
  if (flock.jump && !state.life.jump.empty()) {
    if (state.life.jump[slot] > 0)
      out.flags |= is_jumping;
    else if (!(state.life.rest[slot] > 0))
      out.flags |= can_jump;
  }
  for (std::size_t i = 0; i < 3 && !state.colour[0].empty(); ++i)
    out.colour[i] = byte_of(state.colour[i][slot]);
  if (!state.colour[0].empty()) out.colour[3] = 255;
  return out;
}

/// A simulation's moment as the session would pack it.
inline Frame frame_of(const sturnus::Simulation& simulation) {
  const sturnus::View view = simulation.view();
  Frame out;
  out.step = view.step();
  out.dimensions = view.dimensions();
  out.has_previous = view.has_previous();
  out.extent = sturnus::extent_of(view.scenario());
  out.scenario = std::make_shared<sturnus::ScenarioDef>(view.scenario());
  out.obstacles = view.state().obstacles;
  for (std::size_t slot = 0; slot < view.size(); ++slot)
    out.boids.push_back(instance_of(view, slot, out.extent));
  const sturnus::Food& food = view.state().food;
  for (std::size_t i = 0; i < food.size(); ++i) {
    Piece piece{{}, static_cast<float>(view.scenario().food[food.kind[i]].size), food.kind[i]};
    for (std::size_t axis = 0; axis < 3 && !food.position[axis].empty(); ++axis)
      piece.position[axis] = food.position[axis][i];
    out.food.push_back(piece);
  }
  for (const sturnus::TargetDef& target : view.scenario().targets) {
    TargetPlace place{{}, target.kind == sturnus::TargetKind::repel, static_cast<float>(target.radius)};
    for (std::size_t axis = 0; axis < target.at.size(); ++axis)
      place.at[axis] = static_cast<float>(target.at[axis]);
    out.targets.push_back(place);
  }
  return out;
}

}  // namespace studio::testing_support
