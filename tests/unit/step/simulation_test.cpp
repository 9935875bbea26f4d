// Simulation: creation with its refusals, snapshots, branches, events, and boxes of the index.
#include <gtest/gtest.h>

#include "support.h"

namespace sturnus::test {
namespace {

std::string refusal(const ScenarioDef& scenario, const SimulationOptions& options = {}) {
  const Result<Simulation> result = Simulation::create(scenario, options);
  EXPECT_FALSE(result);
  return result.error();
}

TEST(Create, RefusesWhatCheckRefuses) {
  ScenarioDef scenario;
  scenario.flocks.front().max_speed = 0.5;
  EXPECT_NE(refusal(scenario).find("max_speed"), std::string::npos);
}

TEST(Create, RefusesMoreBoidsThanTheMemoryHolds) {
  ScenarioDef scenario;
  scenario.flocks.front().count = 1000000000;
  EXPECT_NE(refusal(scenario).find("GB"), std::string::npos);
}

TEST(Create, RefusesTablesThatAreMissingOrDoNotFit) {
  ScenarioDef scenario;
  scenario.run.initial = "start.csv";
  EXPECT_NE(refusal(scenario).find("start.csv"), std::string::npos);
  SimulationOptions options;
  options.tables["start.csv"] = state_of(3, {{{1, 2, 3}}});
  EXPECT_NE(refusal(scenario, options).find("3 dimensions"), std::string::npos);
  options.tables["start.csv"] = state_of(2, {{{1, 2}, {}, 5}});
  EXPECT_NE(refusal(scenario, options).find("flock 5"), std::string::npos);
  scenario.run.initial.clear();
  scenario.flocks.front().start.file = "other.csv";
  EXPECT_NE(refusal(scenario, options).find("flock.boids.start.file"), std::string::npos);
}

TEST(Create, TakesAFlockFromItsOwnTable) {
  ScenarioDef scenario = bare();
  scenario.flocks.push_back(scenario.flocks.front());
  scenario.flocks[1].name = "others";
  scenario.flocks[0].count = 2;
  scenario.flocks[1].start.file = "others.csv";
  SimulationOptions options;
  options.tables["others.csv"] = state_of(2, {{{9, 9}, {}, 1}, {{8, 8}, {}, 0}});
  const Simulation simulation = take(Simulation::create(scenario, options));
  EXPECT_EQ(simulation.view().state().flock, (std::vector<std::uint8_t>{0, 0, 1}));
  EXPECT_EQ(simulation.view().position(2), (Point{9, 9, 0}));
}

TEST(Create, StandsAtItsFirstStepWithThatStepsEventsDone) {
  ScenarioDef scenario = bare();
  scenario.flocks.front().count = 1;
  scenario.run.first_step = 40;
  scenario.run.events = {{40, AddBoids{"boids", 2, {0, 0}, 0}}, {41, AddBoids{"boids", 4, {0, 0}, 0}}};
  Simulation simulation = start(scenario);
  EXPECT_EQ(simulation.step_number(), 40u);
  EXPECT_EQ(simulation.view().size(), 3u);
  simulation.step();
  EXPECT_EQ(simulation.view().size(), 7u);
}

TEST(Create, ASavedStateHasItsBoidsAlreadyAndOnlyItsSettingsAreDoneAgain) {
  ScenarioDef scenario = bare();
  scenario.run.first_step = 40;
  scenario.run.events = {{10, AddBoids{"boids", 2, {0, 0}, 0}},
                         {20, SetParameter{"flock.boids.max_speed", "3"}},
                         {30, MovePointer{PointerMode::repel, {1, 2}, true}}};
  const Simulation simulation = world_of(scenario, {{{5, 5}}});
  EXPECT_EQ(simulation.view().size(), 1u);
  EXPECT_EQ(simulation.scenario().flocks.front().max_speed, 3);
  EXPECT_TRUE(simulation.view().state().pointer.pressed);
}

ScenarioDef lively() {
  ScenarioDef scenario;
  scenario.flocks.front().count = 80;
  scenario.flocks.front().min_speed = 1;
  scenario.flocks.front().max_speed = 2;
  scenario.flocks.front().wander = Wander{};
  scenario.flocks.front().noise = Noise{.acceleration = 0.05};
  return scenario;
}

TEST(Snapshot, RunningOnFromItIsRunningOn) {
  Simulation simulation = start(lively());
  simulation.run(10);
  const Snapshot moment = simulation.snapshot();
  const std::uint64_t then = simulation.hash();
  EXPECT_EQ(moment.step(), 10u);
  simulation.run(20);
  const std::uint64_t later = simulation.hash();
  simulation.restore(moment);
  EXPECT_EQ(simulation.hash(), then);
  EXPECT_EQ(simulation.step_number(), 10u);
  EXPECT_FALSE(simulation.view().has_previous());
  simulation.run(20);
  EXPECT_EQ(simulation.hash(), later);
}

TEST(Snapshot, LaterEventsAreDoneAgain) {
  Simulation simulation = start(lively());
  simulation.run(5);
  const Snapshot moment = simulation.snapshot();
  simulation.run(5);
  must(simulation.push(SetParameter{"flock.boids.max_speed", "3"}));
  must(simulation.push(AddBoids{"boids", 3, {0, 0}, 2}));
  simulation.run(5);
  const std::uint64_t end = simulation.hash();
  simulation.restore(moment);
  EXPECT_EQ(simulation.scenario().flocks.front().max_speed, 2);
  simulation.run(10);
  EXPECT_EQ(simulation.hash(), end);
  EXPECT_EQ(simulation.scenario().flocks.front().max_speed, 3);
}

TEST(Snapshot, ActingAfterARestoreBeginsABranch) {
  Simulation simulation = start(lively());
  simulation.run(5);
  const Snapshot moment = simulation.snapshot();
  simulation.run(5);
  must(simulation.push(AddBoids{"boids", 3, {0, 0}, 2}));
  simulation.run(5);
  const std::uint64_t first_branch = simulation.hash();
  simulation.restore(moment);
  simulation.run(1);
  must(simulation.push(AddBoids{"boids", 1, {5, 5}, 0}));
  simulation.run(9);
  EXPECT_EQ(simulation.view().size(), 81u);
  EXPECT_NE(simulation.hash(), first_branch);
  Simulation again = start(simulation.recording());
  again.run(15);
  EXPECT_EQ(again.hash(), simulation.hash());
}

TEST(Snapshot, EventsOfTheScenarioItselfOutliveABranch) {
  ScenarioDef scenario = lively();
  scenario.run.events = {{8, AddBoids{"boids", 5, {0, 0}, 1}}};
  Simulation simulation = start(scenario);
  simulation.run(2);
  const Snapshot moment = simulation.snapshot();
  simulation.run(3);
  simulation.restore(moment);
  must(simulation.push(SetParameter{"flock.boids.max_speed", "3"}));
  simulation.run(10);
  EXPECT_EQ(simulation.view().size(), 85u);
}

TEST(Recording, IsTheScenarioAsItBeganWithAllEvents) {
  Simulation simulation = start(lively());
  simulation.run(3);
  must(simulation.push(SetParameter{"flock.boids.max_speed", "3"}));
  const ScenarioDef recording = simulation.recording();
  EXPECT_EQ(recording.flocks.front().max_speed, 2);
  ASSERT_EQ(recording.run.events.size(), 1u);
  EXPECT_EQ(recording.run.events.front().step, 3u);
}

TEST(IndexBoxes, AreTheBoxesOfTheIndexThatIsAsked) {
  ScenarioDef scenario;
  EXPECT_GT(start(scenario).index_boxes().size(), 10u);
  scenario.index.kind = IndexKind::tree;
  EXPECT_GT(start(scenario).index_boxes().size(), 10u);
  scenario.index.kind = IndexKind::all_pairs;
  EXPECT_EQ(start(scenario).index_boxes().size(), 1u);
  scenario.flocks.front().count = 0;
  EXPECT_EQ(start(scenario).index_boxes().size(), 0u);
}

TEST(Simulation, MovesAndStaysWhole) {
  Simulation first = start(lively());
  const std::uint64_t hash = first.hash();
  Simulation second = std::move(first);
  EXPECT_EQ(second.hash(), hash);
  second.step();
  first = std::move(second);
  EXPECT_EQ(first.step_number(), 1u);
}

}  // namespace
}  // namespace sturnus::test
