// The scenario as it stands: what is placed and set belongs to it, in files, in the clipboard and when the
// world starts again.
#include "session/arrangement.h"

#include <sturnus/parameters.h>

#include "session/world.h"
#include "studio_support.h"

namespace studio {
namespace {

using namespace sturnus;

constexpr std::size_t plenty = std::size_t{64} << 20;

ScenarioDef pond() {
  ScenarioDef scenario = *load_scenario("sharks-and-fish");
  scenario.flocks[0].count = 40;
  scenario.food[0].random.every = 0;
  return scenario;
}

Simulation opened(const ScenarioDef& scenario) {
  auto simulation = open_simulation(scenario, 1);
  EXPECT_TRUE(simulation) << simulation.error();
  return std::move(*simulation);
}

void run(World& world, int steps) {
  for (int i = 0; i < steps; ++i) world.step();
}

void place_all(World& world) {
  ASSERT_TRUE(world.act(PlaceObstacle{{100, 120}, 15}, "obstacle"));
  ASSERT_TRUE(world.act(SetParameter{"flock.fish.avoid_obstacles.weight", "0.5"}, ""));
  run(world, 10);
  ASSERT_TRUE(world.act(PlaceTarget{TargetKind::attract, {300, 200}, SteeringForm::heading, 0.1, 200}, "a"));
  ASSERT_TRUE(world.act(AddBoids{"fish", 8, {400, 300}, 10}, "units"));
  run(world, 10);
  ASSERT_TRUE(world.act(AddFood{"plankton", 1, {500, 100}, 0}, "food"));
  ASSERT_TRUE(world.act(AddBoids{"sharks", 1, {600, 500}, 0}, "predator"));
  ASSERT_TRUE(world.act(SetParameter{"flock.fish.cohesion.weight", "1.25"}, "weight"));
  ASSERT_TRUE(world.act(ScatterBoids{{400, 300}, 100}, "scatter"));
  ASSERT_TRUE(world.act(MovePointer{PointerMode::attract, {1, 1}, true}, "drag"));
  run(world, 10);
}

// As it begins, read back from its own text.
World again(const ScenarioDef& scenario) {
  const auto read = parse_scenario(to_toml(scenario), "again.toml");
  EXPECT_TRUE(read) << read.error();
  return {opened(*read), plenty};
}

void expect_all_placed(const World& world) {
  const State& state = world.simulation().view().state();
  const ScenarioDef& scenario = world.simulation().scenario();
  ASSERT_EQ(state.obstacles.size(), 1u);
  EXPECT_EQ(state.obstacles[0].at, (std::array<float, 3>{100, 120, 0}));
  EXPECT_EQ(state.obstacles[0].radius, 15);
  EXPECT_TRUE(scenario.flocks[0].avoid_obstacles);
  ASSERT_EQ(scenario.targets.size(), 1u);
  EXPECT_EQ(scenario.targets[0].at, (Coordinates{300, 200}));
  EXPECT_EQ(std::count(state.flock.begin(), state.flock.end(), 0), 48);
  EXPECT_EQ(std::count(state.flock.begin(), state.flock.end(), 1), 5);
  ASSERT_EQ(state.food.size(), 21u);
  EXPECT_EQ(state.food.position[0].back(), 500);
  EXPECT_EQ(scenario.flocks[0].cohesion[0].weight, 1.25);
  EXPECT_FALSE(state.pointer.pressed);
}

TEST(StudioArrangement, HasAllThatWasPlacedFromItsStart) {
  World world(opened(pond()), plenty);
  place_all(world);
  const ScenarioDef scenario = world.arranged();
  ASSERT_EQ(scenario.obstacles.size(), 1u);
  ASSERT_EQ(scenario.run.events.size(), 3u) << "two additions and a piece of food";
  for (const Event& event : scenario.run.events) EXPECT_EQ(event.step, 0u);
  expect_all_placed(again(scenario));
}

TEST(StudioArrangement, StartingAgainIsOpeningItAndDoesNotAddUp) {
  World world(opened(pond()), plenty);
  place_all(world);
  const ScenarioDef scenario = world.arranged();
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(world.restart(scenario.seed));
    EXPECT_EQ(world.simulation().step_number(), 0u);
    expect_all_placed(world);
    EXPECT_EQ(to_toml(world.arranged()), to_toml(scenario));
    run(world, 20);
  }
  World read = again(scenario);
  run(read, 20);
  EXPECT_EQ(world.simulation().hash(), read.simulation().hash());
}

TEST(StudioArrangement, WhatTheEraserWentOverIsNotInIt) {
  World world(opened(pond()), plenty);
  const std::string before = to_toml(world.arranged());
  place_all(world);
  ASSERT_TRUE(world.act(EraseBoids{{100, 120}, 5}, "erase"));
  ASSERT_TRUE(world.act(EraseBoids{{300, 200}, 5}, "erase"));
  ASSERT_TRUE(world.act(EraseBoids{{400, 300}, 5}, "erase"));
  ASSERT_TRUE(world.act(EraseBoids{{500, 100}, 5}, "erase"));
  const ScenarioDef scenario = world.arranged();
  EXPECT_TRUE(scenario.obstacles.empty());
  EXPECT_TRUE(scenario.targets.empty());
  ASSERT_EQ(scenario.run.events.size(), 1u);
  EXPECT_EQ(std::get<AddBoids>(scenario.run.events[0].command).flock, "sharks");
  // Also after another start, when they are events of the scenario.
  ASSERT_TRUE(world.restart(1));
  ASSERT_TRUE(world.act(EraseBoids{{600, 500}, 5}, "erase"));
  EXPECT_TRUE(world.arranged().run.events.empty());
}

TEST(StudioArrangement, RandomObstaclesStayRandomUntilOneIsErased) {
  ScenarioDef scenario = *load_scenario("ucsd");
  scenario.flocks[0].count = 10;
  scenario.obstacles.resize(1);
  scenario.obstacles[0].boxes = {{100, 100, 140, 150}};
  scenario.obstacles[0].planes = {{0, 5, 0, 1}};
  scenario.obstacles[0].random = RandomObstacles{.count = 6};
  World world(opened(scenario), plenty);
  ASSERT_TRUE(world.act(PlaceObstacle{{700, 400}, 15}, "obstacle"));
  ScenarioDef placed = world.arranged();
  ASSERT_EQ(placed.obstacles.size(), 2u);
  EXPECT_TRUE(placed.obstacles[0].random);
  EXPECT_EQ(placed.obstacles[1].spheres, (std::vector<Coordinates>{{700, 400, 15}}));
  ASSERT_TRUE(world.act(EraseBoids{{120, 125}, 5}, "erase"));  // the box
  placed = world.arranged();
  EXPECT_EQ(again(placed).simulation().view().state().obstacles, world.simulation().view().state().obstacles);
}

TEST(StudioArrangement, TheScenariosOwnEventsStayEvents) {
  ScenarioDef scenario = pond();
  scenario.run.events = {{0, AddFood{"plankton", 2, {10, 10}, 0}},
                         {8, PlaceObstacle{{50, 50}, 9}},
                         {500, SetParameter{"flock.fish.max_speed", "6"}}};
  World world(opened(scenario), plenty);
  run(world, 20);
  EXPECT_EQ(to_toml(world.arranged()), to_toml(scenario));
  ASSERT_TRUE(world.act(AddBoids{"fish", 8, {400, 300}, 10}, "units"));
  const ScenarioDef placed = world.arranged();
  ASSERT_EQ(placed.run.events.size(), 4u);
  EXPECT_EQ(placed.run.events[1].step, 0u);
  EXPECT_EQ(std::get<AddBoids>(placed.run.events[1].command).count, 8);
}

TEST(StudioArrangement, IsThatOfTheMomentThatIsLookedAt) {
  World world(opened(pond()), plenty);
  place_all(world);
  while (!world.go_to(5)) {
  }
  EXPECT_EQ(world.arranged().obstacles.size(), 1u);
  EXPECT_TRUE(world.arranged().targets.empty());
  EXPECT_TRUE(world.arranged().run.events.empty());
}

class StudioArranging : public StudioTest {};

TEST_F(StudioArranging, TheClipboardAndTheSavedScenarioHoldWhatWasPlaced) {
  open("ucsd");
  desk().session.act(PlaceObstacle{{700, 400}, 15}, "obstacle");
  desk().session.act(PlaceTarget{TargetKind::attract, {300, 200}, SteeringForm::heading, 0.1, 200}, "target");
  desk().session.act(AddBoids{"birds", 16, {100, 100}, 5}, "units");
  frames(10);
  desk().files.save_scenario(desk(), "mine");
  press(SDLK_c, KMOD_LCTRL);
  char* held = SDL_GetClipboardText();
  const std::string copied = held;
  SDL_free(held);
  EXPECT_EQ(copied, read("mine.toml"));
  press(SDLK_v, KMOD_LCTRL);
  EXPECT_EQ(desk().frame->obstacles.size(), 1u);
  EXPECT_EQ(desk().frame->targets.size(), 1u);
  EXPECT_EQ(desk().frame->boids.size(), 66u);
}

}  // namespace
}  // namespace studio
