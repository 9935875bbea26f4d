// The engine against the five references in double precision: at each of 300 steps one reference step from
// the engine's own state, and ten steps in which both run free.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <functional>

#include "reference.h"
#include "support.h"

namespace sturnus::test {
namespace {

using Reference = std::function<reference::Step(const reference::Boids&)>;

constexpr std::size_t boid_count = 300;
constexpr std::uint64_t steps = 300;
constexpr std::uint64_t free_steps = 10;

/// One published system: as the engine runs it, and the document's own rules.
struct Profile {
  ScenarioDef scenario;
  Reference reference;
  double top_speed;      ///< length per time
  double world;          ///< length of the longest side
  reference::Vec sides;  ///< length; 0 on an axis that does not wrap
  double velocity_tolerance = 2e-5;
  double position_tolerance = 1e-6;
  double free_tolerance = 1e-3;
  std::uint64_t free_every = 100;  ///< steps from one free run to the next
};

ScenarioDef scenario_with(const Coordinates& min, const Coordinates& max, BoundaryKind boundary) {
  ScenarioDef scenario;
  scenario.space.dimensions = static_cast<std::int64_t>(min.size());
  scenario.space.min = min;
  scenario.space.max = max;
  scenario.space.boundary.kind = boundary;
  FlockDef& flock = scenario.flocks.front();
  flock.count = boid_count;
  flock.max_acceleration = infinity;
  return scenario;
}

void set_speeds(FlockDef& flock, double min, double max) {
  flock.min_speed = flock.start.min_speed = min;
  flock.max_speed = flock.start.max_speed = max;
}

ScenarioDef ucsd_in_code() {
  ScenarioDef scenario = scenario_with({0, 0}, {1280, 720}, BoundaryKind::turn);
  scenario.space.boundary.margin = {200, 160};
  scenario.space.boundary.strength = 0.5;
  FlockDef& flock = scenario.flocks.front();
  set_speeds(flock, 5, 10);
  flock.separation = {{.weight = 0.02, .radius = 30, .strength = Strength::grows, .combine = Combine::mean}};
  flock.alignment = {{.weight = 0.03, .radius = 150}};
  flock.cohesion = {{.weight = 0.001, .radius = 150}};
  return scenario;
}

ScenarioDef prog06_in_code() {
  ScenarioDef scenario = scenario_with({-0.5, -0.5}, {0.5, 0.5}, BoundaryKind::turn);
  scenario.space.boundary.strength = 0.02;
  FlockDef& flock = scenario.flocks.front();
  set_speeds(flock, 0, 0.05);
  flock.max_acceleration = 0.02;
  flock.separation = {{.weight = 0.1, .radius = 0.4, .edge = Edge::closed}};
  flock.alignment = {{.weight = 0.3, .radius = infinity}};
  flock.cohesion = {{.weight = 1.0, .radius = infinity}};
  return scenario;
}

ScenarioDef vuw_in_code() {
  ScenarioDef scenario = scenario_with({-20, -20, -20}, {20, 20, 20}, BoundaryKind::wrap);
  scenario.time.dt = 1.0 / 60.0;
  scenario.time.integrator = Integrator::explicit_euler;
  FlockDef& flock = scenario.flocks.front();
  flock.name = "red";
  set_speeds(flock, 4, 8);
  flock.separation = {{.weight = 4, .radius = 2, .edge = Edge::closed}};
  flock.alignment = {{.weight = 1.0, .radius = 5, .edge = Edge::closed, .count_self = true}};
  flock.cohesion = {{.weight = 0.6, .radius = 5, .edge = Edge::closed, .count_self = true}};
  scenario.flocks.push_back(flock);
  scenario.flocks.back().name = "blue";
  return scenario;
}

ScenarioDef quadtree_in_code() {
  ScenarioDef scenario = scenario_with({0, 0}, {1600, 900}, BoundaryKind::turn);
  scenario.space.boundary.margin = {100};
  scenario.space.boundary.strength = 0.2;
  scenario.index.kind = IndexKind::tree;
  FlockDef& flock = scenario.flocks.front();
  set_speeds(flock, 3, 6);
  flock.field_of_view = 240;
  flock.separation = {{.weight = 0.002, .radius = 50, .strength = Strength::grows}};
  flock.alignment = {{.weight = 0.09, .radius = 150}};
  flock.cohesion = {{.weight = 0.0009, .radius = 150}};
  return scenario;
}

ScenarioDef cs184_in_code() {
  ScenarioDef scenario = scenario_with({0, 0}, {800, 600}, BoundaryKind::wrap);
  FlockDef& flock = scenario.flocks.front();
  set_speeds(flock, 0, 4);
  flock.max_acceleration = 0.3;
  flock.separation = {{.weight = 3, .radius = 12, .combine = Combine::mean}};
  flock.alignment = {{.weight = 0.06, .radius = 28, .inner = 12, .match = Match::heading, .relative = false}};
  flock.cohesion = {{.weight = 2, .radius = 60, .inner = 28, .strength = Strength::fades}};
  flock.cruise = Cruise{.speed = 2.5, .weight = 0.1};
  return scenario;
}

template <class Term>
void look_at_everybody(ScenarioDef& scenario, const std::string& path, const std::vector<Term>& terms) {
  for (std::size_t i = 0; i < terms.size(); ++i) {
    set(scenario, terms.size() == 1 ? path + ".sample" : path + "." + std::to_string(i) + ".sample", "1");
  }
}

/// 300 boids in all, shared out among the flocks, without noise and sampling.
void make_comparable(ScenarioDef& scenario) {
  const std::size_t flocks = scenario.flocks.size();
  for (std::size_t i = 0; i < flocks; ++i) {
    const FlockDef flock = scenario.flocks[i];
    const std::string path = "flock." + flock.name;
    set(scenario, path + ".count", std::to_string(boid_count * (i + 1) / flocks - boid_count * i / flocks));
    if (flock.noise) set(scenario, path + ".noise.on", "false");
    look_at_everybody(scenario, path + ".separation", flock.separation);
    look_at_everybody(scenario, path + ".alignment", flock.alignment);
    look_at_everybody(scenario, path + ".cohesion", flock.cohesion);
  }
}

/// The shipped scenario of that name, or the same in code where it is not shipped.
ScenarioDef scenario_called(const std::string& name, const ScenarioDef& in_code) {
  ScenarioDef scenario = in_code;
  for (const ShippedScenario& shipped : shipped_scenarios()) {
    if (shipped.name == name) scenario = take(parse_scenario(shipped.text, name));
  }
  make_comparable(scenario);
  return scenario;
}

reference::Boids boids_of(const View& view) {
  reference::Boids boids;
  for (const std::uint32_t slot : view.slots_by_id()) {
    const Point p = view.position(slot);
    const Point v = view.velocity(slot);
    boids.position.push_back({p[0], p[1], p[2]});
    boids.velocity.push_back({v[0], v[1], v[2]});
    boids.flock.push_back(view.flock(slot));
  }
  return boids;
}

double across(double offset, double side) {
  return side > 0 ? reference::nearest_image(offset, side) : offset;
}

/// The largest differences of the boids that are not exempt, relative to top speed and world.
struct Errors {
  double velocity = 0, position = 0;

  void gather(const reference::Boids& engine, const reference::Boids& exact, const std::vector<bool>& exempt,
              const Profile& profile) {
    ASSERT_EQ(engine.position.size(), exact.position.size());
    for (std::size_t i = 0; i < engine.position.size(); ++i) {
      if (exempt[i]) continue;
      const reference::Vec o = engine.position[i] - exact.position[i];
      const reference::Vec nearest = {across(o.x, profile.sides.x), across(o.y, profile.sides.y),
                                      across(o.z, profile.sides.z)};
      const double in_velocity = length(engine.velocity[i] - exact.velocity[i]) / profile.top_speed;
      const double in_position = length(nearest) / profile.world;
      ASSERT_TRUE(std::isfinite(in_velocity) && std::isfinite(in_position)) << "boid " << i;
      velocity = std::max(velocity, in_velocity);
      position = std::max(position, in_position);
    }
  }
};

/// A reference that runs free from one of the engine's states.
struct FreeRun {
  reference::Boids boids;
  std::vector<bool> exempt = std::vector<bool>(boid_count);

  void step(const Reference& rules) {
    const reference::Step next = rules(boids);
    boids = next.next;
    for (std::size_t i = 0; i < boid_count; ++i) exempt[i] = exempt[i] || next.exempt[i];
  }
};

void compare(const std::string& name, const Profile& profile) {
  Simulation engine = start(profile.scenario);
  Errors one_step, free_run;
  FreeRun free;
  double exempt = 0;
  for (std::uint64_t step = 0; step < steps; ++step) {
    const reference::Boids before = boids_of(engine.view());
    ASSERT_EQ(before.position.size(), boid_count);
    const reference::Step exact = profile.reference(before);
    if (step % profile.free_every == 0) free = {before};
    if (step % profile.free_every < free_steps) free.step(profile.reference);
    engine.step();
    const reference::Boids after = boids_of(engine.view());
    ASSERT_NO_FATAL_FAILURE(one_step.gather(after, exact.next, exact.exempt, profile)) << "step " << step;
    exempt += static_cast<double>(std::count(exact.exempt.begin(), exact.exempt.end(), true));
    if (step % profile.free_every + 1 == free_steps) free_run.gather(after, free.boids, free.exempt, profile);
  }
  EXPECT_EQ(engine.report().quarantined, 0u);
  exempt /= static_cast<double>(steps * boid_count);
  EXPECT_LE(one_step.velocity, profile.velocity_tolerance);
  EXPECT_LE(one_step.position, profile.position_tolerance);
  EXPECT_LE(exempt, 0.01);
  EXPECT_LE(free_run.velocity, profile.free_tolerance);
  EXPECT_LE(free_run.position, profile.free_tolerance);
  std::printf(
      "%-9s one step: velocity %.2g, position %.2g; free: velocity %.2g, position %.2g; exempt %.4f %%\n",
      name.c_str(), one_step.velocity, one_step.position, free_run.velocity, free_run.position, 100 * exempt);
}

TEST(EngineAgainstReference, Ucsd) {
  compare("ucsd", {scenario_called("ucsd", ucsd_in_code()),
                   [](const reference::Boids& boids) { return reference::ucsd(boids); },
                   10,
                   1280,
                   {}});
}

TEST(EngineAgainstReference, Prog06) {
  Profile profile{scenario_called("prog06", prog06_in_code()),
                  [](const reference::Boids& boids) { return reference::prog06(boids); },
                  0.05,
                  1,
                  {}};
  profile.velocity_tolerance = 1e-4;
  profile.free_tolerance = 1e-2;
  profile.free_every =
      steps;  // only from the start: later the boids swarm so densely that errors grow tenfold
  compare("prog06", profile);
}

TEST(EngineAgainstReference, VuwCore) {
  compare("vuw-core", {scenario_called("vuw-core", vuw_in_code()),
                       [](const reference::Boids& boids) { return reference::vuw_core(boids); },
                       8,
                       40,
                       {40, 40, 40}});
}

TEST(EngineAgainstReference, Quadtree) {
  compare("quadtree", {scenario_called("quadtree", quadtree_in_code()),
                       [](const reference::Boids& boids) { return reference::quadtree(boids); },
                       6,
                       1600,
                       {}});
}

TEST(EngineAgainstReference, Cs184) {
  compare("cs184", {scenario_called("cs184", cs184_in_code()),
                    [](const reference::Boids& boids) { return reference::cs184(boids); },
                    4,
                    800,
                    {800, 600, 0}});
}

}  // namespace
}  // namespace sturnus::test
