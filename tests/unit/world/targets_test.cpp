// Targets that are placed, moved and erased on the way; the burst; and that a run knows them when it goes on.
#include <gtest/gtest.h>

#include "support.h"

namespace sturnus::test {
namespace {

ScenarioDef calm() {
  ScenarioDef scenario = bare();
  scenario.flocks.front().max_speed = 5;
  scenario.flocks.front().count = 40;
  scenario.flocks.front().start.region = StartRegion::ball;
  scenario.flocks.front().start.radius = 100;
  return scenario;
}

TEST(PlacedTargets, TakeTheNextFreeNameAndAreFelt) {
  Simulation simulation = start(calm());
  must(simulation.push(PlaceTarget{TargetKind::attract, {500, 0}, SteeringForm::linear, 0.1, infinity}));
  must(simulation.push(PlaceTarget{TargetKind::repel, {0, 500}, SteeringForm::seek, 0.1, 50}));
  ASSERT_EQ(simulation.scenario().targets.size(), 2u);
  EXPECT_EQ(simulation.scenario().targets[0].name, "target");
  EXPECT_EQ(simulation.scenario().targets[1].name, "target-2");
  simulation.run(50);
  for (std::size_t i = 0; i < simulation.view().size(); ++i) EXPECT_GT(simulation.view().velocity(i)[0], 4);
  must(simulation.push(SetParameter{"target.target.at", "[-500, 0]"}));
  simulation.run(50);
  for (std::size_t i = 0; i < simulation.view().size(); ++i) EXPECT_LT(simulation.view().velocity(i)[0], -4);
}

TEST(PlacedTargets, AreErasedWhereTheyAreThen) {
  ScenarioDef scenario = calm();
  TargetDef target;
  target.name = "roaming";
  target.at = {0, 0};
  target.motion = TargetMotion::line;
  target.velocity = {10, 0};
  scenario.targets = {target};
  Simulation simulation = start(scenario);
  simulation.run(30);
  must(simulation.push(EraseBoids{{0, 900}, 1}));
  must(simulation.push(EraseBoids{{0, 0}, 0.5}));
  EXPECT_EQ(simulation.scenario().targets.size(), 1u);
  must(simulation.push(EraseBoids{{300, 0}, 1}));
  EXPECT_TRUE(simulation.scenario().targets.empty());
}

TEST(PlacedTargets, AreRecordedReplayedAndKeptOverRewinding) {
  Simulation simulation = start(calm());
  simulation.run(3);
  const Snapshot before = simulation.snapshot();
  must(simulation.push(PlaceTarget{TargetKind::attract, {50, 0}, SteeringForm::arrive, 0.2, 500}));
  simulation.run(5);
  must(simulation.push(ScatterBoids{{0, 0}, 60}));
  simulation.run(5);
  must(simulation.push(EraseBoids{{50, 0}, 3}));
  simulation.run(5);
  const ScenarioDef recording = simulation.recording();
  Simulation again = start(take(parse_scenario(to_toml(recording), "again.toml")));
  again.run(18);
  EXPECT_EQ(again.hash(), simulation.hash());
  simulation.restore(before);
  EXPECT_TRUE(simulation.scenario().targets.empty());
  simulation.run(15);
  EXPECT_EQ(again.hash(), simulation.hash());
}

TEST(PlacedTargets, AreThereWhenASavedStateGoesOn) {
  ScenarioDef scenario = calm();
  scenario.run.events = {
      {2, PlaceTarget{TargetKind::attract, {50, 0}, SteeringForm::orbit, 0.2, 500}},
      {3, PlaceTarget{TargetKind::attract, {-300, 0}, SteeringForm::linear, 0.1, infinity}},
      {4, SetParameter{"target.target.weight", "0.3"}},
      {5, EraseBoids{{-300, 0}, 1}},
      {12, EraseBoids{{50, 0}, 1}}};
  Simulation whole = start(scenario);
  whole.run(8);
  ScenarioDef rest = scenario;
  rest.run.first_step = 8;
  Simulation half = world_from(rest, whole.view().state());
  ASSERT_EQ(half.scenario().targets.size(), 1u);
  EXPECT_EQ(half.scenario().targets.front().weight, 0.3);
  whole.run(10);
  half.run(10);
  EXPECT_EQ(half.hash(), whole.hash());
}

TEST(Scatter, MakesThoseWithinReachFlyAwayAtFullSpeed) {
  Simulation simulation = world_of(calm(), {{{3, 4}, {1, 0}}, {{0, 0}, {0, -2}}, {{0, 11}, {0, 1}}});
  must(simulation.push(ScatterBoids{{0, 0}, 10}));
  const auto expect_velocity = [&](std::uint64_t id, const Point& expected) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(velocity_of(simulation, id)[axis], expected[axis], 1e-6) << "boid " << id;
  };
  expect_velocity(0, {3, 4, 0});
  expect_velocity(1, {0, -5, 0});  // at the very place: on along its heading
  expect_velocity(2, {0, 1, 0});
}

TEST(Scatter, ReachesOverTheSeam) {
  ScenarioDef scenario = calm();
  scenario.space.boundary.kind = BoundaryKind::wrap;
  Simulation simulation = world_of(scenario, {{{999, 0}, {0, 1}}});
  must(simulation.push(ScatterBoids{{-999, 0}, 10}));
  EXPECT_NEAR(velocity_of(simulation, 0)[0], -5, 1e-6);
}

TEST(Scatter, WithoutATopSpeedKeepsTheSpeed) {
  ScenarioDef scenario = calm();
  scenario.flocks.front().max_speed = infinity;
  Simulation simulation = world_of(scenario, {{{0, 4}, {3, 0}}});
  must(simulation.push(ScatterBoids{{0, 0}, 10}));
  EXPECT_NEAR(velocity_of(simulation, 0)[1], 3, 1e-6);
}

TEST(PlacedTargets, BadEventsAreRefusedInASentence) {
  const auto said = [](const char* event) {
    const auto result = parse_scenario(
        std::string("[run]\nevents = [") + event + "]\n[[flock]]\nmax_speed = inf\n", "x.toml");
    return result ? std::string() : result.error();
  };
  EXPECT_EQ(said(R"([1, "target", "attract", [0, 0]])"), "");
  EXPECT_EQ(said(R"([1, "scatter", [0, 0], 5])"), "");
  for (const auto& [event, word] : std::vector<std::pair<const char*, const char*>>{
           {R"([1, "target", "pull", [0, 0]])", "\"pull\""},
           {R"([1, "target", "attract", [0, 0, 0]])", "2 coordinates"},
           {R"([1, "target", "attract", [0, 0], "arive"])", "did you mean \"arrive\""},
           {R"([1, "target", "attract", [0, 0], "seek"])", "max_speed"},
           {R"([1, "target", "repel", [0, 0], "heading", 1, -5])", "must not be negative"},
           {R"([1, "scatter", [0, 0], -5])", "must not be negative"},
           {R"([1, "set", "target.target.name", "x"])", "can't change"}}) {
    const std::string text = said(event);
    EXPECT_NE(text.find(word), std::string::npos) << event << ": " << text;
    EXPECT_NE(text.find("x.toml:2"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace sturnus::test
