// What the tests share: worlds made by hand, boids found by their ids, and the questions that are asked again
// and again.
#pragma once

#include <sturnus/files.h>
#include <sturnus/parameters.h>
#include <sturnus/simulation.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace sturnus::test {

using Point = std::array<float, 3>;

/// A boid put somewhere by hand; ids are the places in the list.
struct Placed {
  Point position{};
  Point velocity{};
  int flock = 0;
};

/// The value, or a test that fails with the sentences.
template <class T>
T take(Result<T> result) {
  if (!result) throw std::runtime_error(result.error());
  return std::move(*result);
}

inline void must(const Status& status) {
  if (!status) throw std::runtime_error(status.error());
}

inline void set(ScenarioDef& scenario, const std::string& path, const std::string& value) {
  must(set_parameter(scenario, path, parse_value(value)));
}

/// An open world of [-1000, 1000] on every axis with one flock that feels nothing and has no limits: whatever
/// changes a velocity there was put in by the test.
inline ScenarioDef bare(int dimensions = 2) {
  ScenarioDef scenario;
  const auto axes = static_cast<std::size_t>(dimensions);
  scenario.space.dimensions = dimensions;
  scenario.space.min = Coordinates(axes, -1000.0);
  scenario.space.max = Coordinates(axes, 1000.0);
  scenario.space.boundary.kind = BoundaryKind::open;
  FlockDef& flock = scenario.flocks.front();
  flock.separation = {};
  flock.alignment = {};
  flock.cohesion = {};
  flock.min_speed = 0;
  flock.max_speed = infinity;
  flock.max_acceleration = infinity;
  return scenario;
}

inline State state_of(int dimensions, const std::vector<Placed>& boids) {
  State state;
  state.dimensions = dimensions;
  state.next_id = boids.size();
  for (std::size_t i = 0; i < boids.size(); ++i) {
    state.id.push_back(i);
    state.flock.push_back(static_cast<std::uint8_t>(boids[i].flock));
    state.quarantined.push_back(0);
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
      state.position[axis].push_back(boids[i].position[axis]);
      state.velocity[axis].push_back(boids[i].velocity[axis]);
    }
  }
  return state;
}

/// The state as a program reads it that finds it in a file.
inline State through_csv(const State& state) {
  return take(parse_state_csv(state_csv(state), "saved"));
}

/// A world whose boids are exactly those of a state.
inline Simulation world_from(ScenarioDef scenario, const State& state, int threads = 1) {
  scenario.run.initial = "by hand";
  SimulationOptions options;
  options.threads = threads;
  options.tables["by hand"] = state;
  return take(Simulation::create(scenario, options));
}

inline Simulation world_of(const ScenarioDef& scenario, const std::vector<Placed>& boids, int threads = 1) {
  return world_from(scenario, state_of(static_cast<int>(scenario.space.dimensions), boids), threads);
}

/// A world that starts as its scenario says.
inline Simulation start(const ScenarioDef& scenario, int threads = 1) {
  SimulationOptions options;
  options.threads = threads;
  return take(Simulation::create(scenario, options));
}

inline Point position_of(const Simulation& simulation, std::uint64_t id) {
  return simulation.view().position(simulation.view().slot(id).value());
}
inline Point velocity_of(const Simulation& simulation, std::uint64_t id) {
  return simulation.view().velocity(simulation.view().slot(id).value());
}

/// The change of one boid's velocity in the first step, over dt: what it feels where nothing limits it.
inline Point felt_by(const ScenarioDef& scenario, const std::vector<Placed>& boids, std::uint64_t id = 0) {
  Simulation simulation = world_of(scenario, boids);
  simulation.step();
  Point change = velocity_of(simulation, id);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    change[axis] = (change[axis] - boids[id].velocity[axis]) / static_cast<float>(scenario.time.dt);
  }
  return change;
}

inline double length_of(const Point& v) {
  return std::hypot(double{v[0]}, double{v[1]}, double{v[2]});
}

inline double distance(const Point& a, const Point& b) {
  return length_of({a[0] - b[0], a[1] - b[1], a[2] - b[2]});
}

/// Whether no boid's place or velocity is anything but a plain number.
inline bool all_finite(const State& state) {
  for (const Columns* columns : {&state.position, &state.velocity, &state.wander, &state.colour}) {
    for (const auto& column : *columns) {
      for (const float value : column) {
        if (!std::isfinite(value)) return false;
      }
    }
  }
  return true;
}

/// |mean heading| of moving boids (Vicsek 1995), as a test needs it.
inline double order_of(const View& view) {
  std::array<double, 3> sum{};
  double moving = 0;
  for (std::size_t i = 0; i < view.size(); ++i) {
    const Point v = view.velocity(i);
    const double speed = length_of(v);
    if (!(speed > 0)) continue;
    moving += 1;
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += v[axis] / speed;
  }
  return moving > 0 ? std::hypot(sum[0], sum[1], sum[2]) / moving : 0;
}

}  // namespace sturnus::test
