// What docs/living-world.md shows, as laws of its runs.
#include <gtest/gtest.h>
#include <sturnus/measure.h>
#include <sturnus/parameters.h>

#include "support.h"

namespace sturnus::test {
namespace {

ScenarioDef shipped(const std::string& name) {
  for (const ShippedScenario& scenario : shipped_scenarios()) {
    if (name == scenario.name) return take(parse_scenario(scenario.text, name));
  }
  throw std::runtime_error("no scenario " + name);
}

void set_to(ScenarioDef& scenario, const std::string& path, const std::string& value) {
  const Status status = set_parameter(scenario, path, parse_value(value));
  ASSERT_TRUE(static_cast<bool>(status)) << path;
}

// How many are caught of a group by one hunter, over several seeds.
std::size_t caught(int group, const std::string& confusion) {
  std::size_t sum = 0;
  for (const int seed : {1, 2, 3, 4, 5, 6}) {
    ScenarioDef scenario = shipped("confusion");
    scenario.seed = seed;
    set_to(scenario, "flock.prey.count", std::to_string(group));
    set_to(scenario, "flock.hunter.hunt.confusion", confusion);
    Simulation simulation = start(scenario);
    simulation.run(600);
    sum += simulation.report().eaten;
  }
  return sum;
}

TEST(Confusion, MakesALargerGroupSafer) {
  const std::size_t small = caught(20, "0.01"), middle = caught(80, "0.01"), large = caught(320, "0.01");
  EXPECT_GT(small, middle);
  EXPECT_GT(middle, large);
  EXPECT_GT(small, 2 * middle);
}

TEST(Confusion, IsWhatDoesIt) {
  EXPECT_GE(caught(80, "0"), caught(20, "0"));
  EXPECT_GE(caught(320, "0"), caught(80, "0"));
}

// Mean turning in degrees a step, once shoals form.
double turning(const ScenarioDef& scenario) {
  Simulation simulation = start(scenario);
  simulation.run(200);
  double sum = 0;
  for (int step = 0; step < 100; ++step) {
    simulation.step();
    sum += measure(simulation.view()).turning;
  }
  return sum / 100;
}

// Both with steps of the same length, without a cap on the acceleration, and with it as it is shipped.
TEST(Jitter, ComesOfForcesThatAreAddedToTheVelocity) {
  ScenarioDef accelerated = shipped("cs184");
  const ScenarioDef added = shipped("cs184-jitter");
  accelerated.time.dt = added.time.dt;
  const double capped = turning(accelerated);
  accelerated.flocks[0].max_acceleration = infinity;
  const double free = turning(accelerated), jittering = turning(added);
  EXPECT_LT(capped, free);
  EXPECT_LT(3 * free, jittering);
}

// It is the same sum of forces: with steps of 0.1 it changes the velocity ten times as much.
TEST(Jitter, AddsTheVeryForcesToTheVelocity) {
  ScenarioDef accelerated = shipped("cs184");
  ScenarioDef added = shipped("cs184-jitter");
  accelerated.time.dt = added.time.dt;
  accelerated.flocks[0].max_acceleration = infinity;
  for (ScenarioDef* scenario : {&accelerated, &added}) scenario->flocks[0].max_speed = infinity;
  Simulation one = start(accelerated), other = start(added);
  for (int i = 0; i < 500; ++i) {
    const auto id = static_cast<std::uint64_t>(i);
    const auto a = take(one.explain(id)), b = take(other.explain(id));
    const Point force = b.sum;  // per time; 0.1 of it is added
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(double{force[axis]}, 10 * double{a.sum[axis]}, 1e-4 * (1 + std::abs(double{force[axis]})));
  }
}

}  // namespace
}  // namespace sturnus::test
