// Runs that are saved and continued, recorded and replayed, rewound and branched: always the same bits.
#include <gtest/gtest.h>

#include <sturnus/files.h>

#include <cfenv>

#include "support.h"

namespace sturnus::test {
namespace {

ScenarioDef small() {
  ScenarioDef scenario;
  scenario.flocks[0].count = 50;
  scenario.flocks[0].noise = Noise{.acceleration = 0.05};
  return scenario;
}

Simulation start(const ScenarioDef& scenario) {
  return take(Simulation::create(scenario));
}

/// Saves a run at a step as state CSV and goes on from there to the end.
std::uint64_t hash_in_two_parts(ScenarioDef scenario, std::uint64_t at, std::uint64_t end) {
  Simulation first = start(scenario);
  first.run(at);
  scenario.run.initial = "saved";
  scenario.run.first_step = static_cast<std::int64_t>(at);
  scenario.run.resumed = true;
  SimulationOptions options;
  options.tables["saved"] = through_csv(first.view().state());
  Simulation second = take(Simulation::create(scenario, options));
  second.run(end - at);
  return second.hash();
}

std::uint64_t hash_in_one(const ScenarioDef& scenario, std::uint64_t end) {
  Simulation simulation = start(scenario);
  simulation.run(end);
  return simulation.hash();
}

Event event_at(std::uint64_t step, Command command) {
  return {step, std::move(command)};
}
Command set_to(const std::string& path, const std::string& value) {
  return SetParameter{path, value};
}

TEST(Continuation, PastSettingsHoldForTheSavedBoids) {
  for (const auto& [path, value] :
       std::vector<std::pair<std::string, std::string>>{{"flock.boids.wander.weight", "0.1"},
                                                        {"flock.boids.colour.averaging", "0.2"},
                                                        {"space.per_boid", "400"}}) {
    ScenarioDef scenario = small();
    scenario.run.events = {event_at(10, set_to(path, value))};
    EXPECT_EQ(hash_in_two_parts(scenario, 20, 40), hash_in_one(scenario, 40)) << path;
    EXPECT_EQ(hash_in_two_parts(scenario, 10, 40), hash_in_one(scenario, 40)) << path << " at its own step";
  }
}

TEST(Continuation, BoidsThatEventsAddedAreNotAddedAgain) {
  ScenarioDef scenario = small();
  scenario.run.events = {event_at(5, AddBoids{"boids", 7, {10, 20}, 5}),
                         event_at(10, EraseBoids{{10, 20}, 20}),
                         event_at(20, AddBoids{"boids", 5, {0, 0}, 9})};
  for (const std::uint64_t at : {5u, 15u, 20u}) {
    EXPECT_EQ(hash_in_two_parts(scenario, at, 40), hash_in_one(scenario, 40)) << at;
  }
}

TEST(Continuation, ThePointerStaysPressed) {
  ScenarioDef scenario = small();
  scenario.run.events = {event_at(10, MovePointer{PointerMode::repel, {3, 4}, true})};
  EXPECT_EQ(hash_in_two_parts(scenario, 20, 40), hash_in_one(scenario, 40));
}

TEST(Continuation, ARecordingOfAContinuedRunHasWhatWasDoneAtItsFirstStep) {
  ScenarioDef scenario = small();
  scenario.run.events = {event_at(1, MovePointer{PointerMode::attract, {3, 4}, true})};
  Simulation before = start(scenario);
  before.run(3);
  scenario.run.initial = "saved";
  scenario.run.first_step = 3;
  scenario.run.resumed = true;
  SimulationOptions options;
  options.tables["saved"] = through_csv(before.view().state());
  Simulation by_hand = take(Simulation::create(scenario, options));
  must(by_hand.push(AddBoids{"boids", 5, {0, 0}, 4}));
  by_hand.run(10);
  Simulation replay = take(Simulation::create(by_hand.recording(), options));
  replay.run(10);
  EXPECT_EQ(replay.view().size(), 55u);
  EXPECT_EQ(replay.hash(), by_hand.hash());
}

TEST(Branches, TheFilesOwnEventsAreNeverLost) {
  ScenarioDef scenario = small();
  scenario.run.events = {event_at(50, AddBoids{"boids", 3, {0, 0}, 4})};
  Simulation simulation = start(scenario);
  simulation.run(10);
  const Snapshot at_10 = simulation.snapshot();
  simulation.run(10);
  must(simulation.push(EraseBoids{{0, 0}, 10}));
  simulation.run(10);
  const Snapshot at_30 = simulation.snapshot();
  simulation.restore(at_10);
  simulation.run(2);
  must(simulation.push(set_to("flock.boids.max_speed", "2.5")));
  simulation.restore(at_30);
  simulation.run(30);
  Simulation replay = start(simulation.recording());
  replay.run(60);
  EXPECT_EQ(simulation.recording().run.events.size(), 2u);
  EXPECT_EQ(replay.hash(), simulation.hash());
}

TEST(Branches, CommandsOfAnotherBranchStayThere) {
  Simulation simulation = start(small());
  simulation.run(10);
  const Snapshot at_10 = simulation.snapshot();
  simulation.run(20);
  const Snapshot at_30 = simulation.snapshot();
  simulation.run(20);
  const std::uint64_t untouched = simulation.hash();
  simulation.restore(at_10);
  must(simulation.push(set_to("flock.boids.max_speed", "2.5")));
  simulation.run(30);
  must(simulation.push(EraseBoids{{0, 0}, 30}));
  simulation.restore(at_30);
  simulation.run(20);
  EXPECT_EQ(simulation.hash(), untouched);
}

TEST(Branches, WhatNeverWasIsNotDoneAgain) {
  ScenarioDef scenario = small();
  scenario.run.events = {event_at(15, AddBoids{"boids", 3, {0, 0}, 4})};
  Simulation simulation = start(scenario);
  simulation.run(10);
  const Snapshot at_10 = simulation.snapshot();
  must(simulation.push(EraseBoids{{0, 0}, 30}));
  simulation.run(10);
  simulation.restore(at_10, Later::never);
  simulation.run(10);
  Simulation untouched = start(scenario);
  untouched.run(20);
  EXPECT_EQ(simulation.hash(), untouched.hash());
  EXPECT_EQ(simulation.recording().run.events.size(), 1u);
}

TEST(Branches, AMomentBringsBackTheFutureThatItHad) {
  Simulation simulation = start(small());
  simulation.run(10);
  const Snapshot at_10 = simulation.snapshot();
  simulation.run(10);
  must(simulation.push(EraseBoids{{0, 0}, 30}));
  simulation.run(10);
  const std::uint64_t end = simulation.hash();
  simulation.restore(at_10);
  const Snapshot with_future = simulation.snapshot();
  must(simulation.push(set_to("flock.boids.max_speed", "2.5")));
  simulation.run(20);
  EXPECT_NE(simulation.hash(), end);
  simulation.restore(with_future, Later::as_then);
  simulation.run(20);
  EXPECT_EQ(simulation.hash(), end);
}

TEST(Targets, TheirPlacesAreThoseOfTheStep) {
  ScenarioDef scenario = small();
  TargetDef target;
  target.name = "target";
  target.at = {10, 20};
  target.motion = TargetMotion::line;
  target.velocity = {1, -2};
  scenario.targets = {target};
  Simulation simulation = start(scenario);
  simulation.run(3);
  ASSERT_EQ(simulation.target_places().size(), 1u);
  EXPECT_EQ(simulation.target_places()[0], (std::array<float, 3>{13, 14, 0}));
}

TEST(HostSettings, TheHostsRoundingChangesNothing) {
  ScenarioDef scenario = small();
  scenario.space.boundary.kind = BoundaryKind::open;
  scenario.flocks[0].count = 9000;
  scenario.flocks[0].alignment[0].radius = infinity;
  const std::uint64_t usual = hash_in_one(scenario, 3);
  ASSERT_EQ(std::fesetround(FE_UPWARD), 0);
  const std::uint64_t upward = hash_in_one(scenario, 3);
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(upward, usual);
}

TEST(Memory, EventsThatAddMoreThanThereIsRoomForAreRefusedAtOnce) {
  ScenarioDef scenario = small();
  scenario.run.events = {event_at(0, AddBoids{"boids", 1000000000, {0, 0}, 1})};
  const auto refused = Simulation::create(scenario);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().find("run.events: 1000000050 boids need about"), std::string::npos)
      << refused.error();
  EXPECT_FALSE(start(small()).push(AddBoids{"boids", 1000000000, {0, 0}, 1}));
}

TEST(Values, DeepBracketsAreTextAndLongFindingsAreCut) {
  ScenarioDef scenario;
  const std::string deep = std::string(20000, '[') + std::string(20000, ']');
  const Status status = set_parameter(scenario, "seed", parse_value(deep));
  ASSERT_FALSE(status);
  EXPECT_LT(status.error().size(), 200u);
}

TEST(Values, HugeNumbersAndTextThatIsNotUtf8) {
  ScenarioDef scenario;
  must(set_parameter(scenario, "flock.boids.size", parse_value("123456789012345680000")));
  EXPECT_TRUE(parse_scenario(to_toml(scenario), "again"));
  EXPECT_FALSE(set_parameter(scenario, "title", parse_value("\xff")));
}

TEST(SmallSpaces, ASpaceThatSinglePrecisionCannotDivideIsRefused) {
  ScenarioDef scenario;
  scenario.space.per_boid = 1e-300;
  EXPECT_TRUE(has_errors(check(scenario)));
  scenario.space.per_boid.reset();
  scenario.space.min = {16777216, 16777216};
  scenario.space.max = {16777217, 16777217};
  EXPECT_TRUE(has_errors(check(scenario)));
}

}  // namespace
}  // namespace sturnus::test
