// Commands between steps: what each one does to the world, and what it says when it can't.
#include <gtest/gtest.h>

#include "support.h"

namespace sturnus::test {
namespace {

ScenarioDef wrapped_world() {
  ScenarioDef scenario = bare();
  scenario.space.min = {0, 0};
  scenario.space.max = {100, 100};
  scenario.space.boundary.kind = BoundaryKind::wrap;
  return scenario;
}

TEST(Commands, AddPutsBoidsAroundAPlaceWithNewIds) {
  Simulation simulation = world_of(wrapped_world(), {{{1, 1}}});
  must(simulation.push(AddBoids{"boids", 50, {99, 50}, 5}));
  EXPECT_EQ(simulation.view().size(), 51u);
  for (std::uint64_t id = 1; id <= 50; ++id) {
    Point p = position_of(simulation, id);
    EXPECT_TRUE(p[0] >= 0 && p[0] < 100);
    if (p[0] < 50) p[0] += 100;
    EXPECT_LE(distance(p, {99, 50}), 5.0001);
  }
}

TEST(Commands, EraseTakesWhoIsWithinTheRadiusOverTheSeamToo) {
  Simulation simulation = world_of(wrapped_world(), {{{99, 50}}, {{2, 50}}, {{50, 50}}, {{94, 50}}});
  must(simulation.push(EraseBoids{{1, 50}, 2}));
  EXPECT_EQ(simulation.view().state().id, (std::vector<std::uint64_t>{2, 3}));
  must(simulation.push(EraseBoids{{194, 50}, 0}));  // a place outside is its image inside
  EXPECT_EQ(simulation.view().state().id, (std::vector<std::uint64_t>{2}));
  must(simulation.push(AddBoids{"boids", 1, {5, 5}, 0}));
  EXPECT_EQ(simulation.view().state().id, (std::vector<std::uint64_t>{2, 4}));  // ids are never used twice
}

TEST(Commands, AHandInSpaceReachesAlongItsLine) {
  Simulation simulation = world_of(bare(3), {{{1, 0, -500}}, {{0, 1, 500}}, {{4, 0, 0}}});
  must(simulation.push(EraseBoids{{0, 0, 7}, 2, {0, 0, -3}}));
  EXPECT_EQ(simulation.view().state().id, (std::vector<std::uint64_t>{2}));
  must(simulation.push(MovePointer{PointerMode::attract, {0, 0, 0}, true, {0, 4, 0}}));
  EXPECT_EQ(simulation.view().state().pointer.along, (Point{0, 1, 0}));
  EXPECT_FALSE(simulation.push(EraseBoids{{0, 0, 0}, 2, {0, 0, 0}}));
  EXPECT_FALSE(simulation.push(EraseBoids{{0, 0, 0}, 2, {0, 1}}));
}

TEST(Commands, ABurstFromALineGoesStraightAwayFromIt) {
  ScenarioDef scenario = bare(3);
  scenario.flocks.front().max_speed = 5;
  Simulation simulation = world_of(scenario, {{{3, 4, 90}, {1, 0, 0}}, {{30, 40, 0}, {1, 0, 0}}});
  must(simulation.push(ScatterBoids{{0, 0, 0}, 10, {0, 0, 2}}));
  EXPECT_EQ(velocity_of(simulation, 0), (Point{3, 4, 0}));
  EXPECT_EQ(velocity_of(simulation, 1), (Point{1, 0, 0}));
}

TEST(Commands, MoveSetsPlaceAndVelocity) {
  Simulation simulation = world_of(wrapped_world(), {{{1, 1}, {1, 0}}});
  must(simulation.push(MoveBoid{0, {130, 20}, {0, 3}}));
  EXPECT_EQ(position_of(simulation, 0), (Point{30, 20, 0}));
  EXPECT_EQ(velocity_of(simulation, 0), (Point{0, 3, 0}));
}

TEST(Commands, PointerStaysWhereItIsUntilItMoves) {
  Simulation simulation = world_of(wrapped_world(), {{{1, 1}}});
  must(simulation.push(MovePointer{PointerMode::repel, {30, 140}, true}));
  simulation.run(3);
  const PointerState& pointer = simulation.view().state().pointer;
  EXPECT_EQ(pointer.mode, PointerMode::repel);
  EXPECT_TRUE(pointer.pressed);
  EXPECT_EQ(pointer.at, (Point{30, 40, 0}));
}

TEST(Commands, SetChangesTheScenarioAsItStands) {
  Simulation simulation = world_of(wrapped_world(), {{{1, 1}, {9, 0}}});
  must(simulation.push(SetParameter{"flock.boids.max_speed", "4"}));
  EXPECT_EQ(simulation.scenario().flocks.front().max_speed, 4);
  simulation.step();
  EXPECT_EQ(velocity_of(simulation, 0)[0], 4);
}

TEST(Commands, SetBringsWanderAndColourIntoTheStateAndOutAgain) {
  Simulation simulation = world_of(wrapped_world(), {{{1, 1}, {1, 0}}, {{2, 2}, {1, 0}}});
  must(simulation.push(SetParameter{"flock.boids.wander.weight", "0.1"}));
  EXPECT_EQ(simulation.view().state().wander[0].size(), 2u);
  must(simulation.push(SetParameter{"flock.boids.colour.noise", "0.1"}));
  EXPECT_EQ(simulation.view().state().colour[2].size(), 2u);
  must(simulation.push(SetParameter{"flock.boids.colour.noise", "0"}));
  EXPECT_TRUE(simulation.view().state().colour[0].empty());
  EXPECT_EQ(simulation.view().state().wander[0].size(), 2u);
  simulation.run(3);
  EXPECT_EQ(simulation.view().size(), 2u);
}

std::string refusal(Simulation& simulation, const Command& command) {
  const std::uint64_t before = simulation.hash();
  const Status status = simulation.push(command);
  EXPECT_FALSE(status);
  EXPECT_EQ(simulation.hash(), before);
  EXPECT_TRUE(simulation.recording().run.events.empty());
  return status.error();
}

TEST(Commands, SayWhatIsWrongAndChangeNothing) {
  Simulation simulation = world_of(wrapped_world(), {{{1, 1}}});
  const double nan = std::nan("");
  EXPECT_NE(refusal(simulation, SetParameter{"flock.boids.max_sped", "4"}).find("max_speed"),
            std::string::npos);
  EXPECT_NE(refusal(simulation, SetParameter{"seed", "4"}).find("can't change"), std::string::npos);
  EXPECT_NE(refusal(simulation, SetParameter{"flock.boids.min_speed", "-1"}).find("negative"),
            std::string::npos);
  EXPECT_NE(refusal(simulation, SetParameter{"flock.boids.min_speed", "fast"}).find("number"),
            std::string::npos);
  EXPECT_NE(refusal(simulation, AddBoids{"boid", 1, {0, 0}, 0}).find("did you mean \"boids\""),
            std::string::npos);
  EXPECT_NE(refusal(simulation, AddBoids{"boids", 1, {0, 0, 0}, 0}).find("2 coordinates"), std::string::npos);
  EXPECT_NE(refusal(simulation, AddBoids{"boids", -1, {0, 0}, 0}).find("count"), std::string::npos);
  EXPECT_NE(refusal(simulation, EraseBoids{{0, nan}, 1}).find("finite"), std::string::npos);
  EXPECT_NE(refusal(simulation, EraseBoids{{0, 0}, nan}).find("radius"), std::string::npos);
  EXPECT_NE(refusal(simulation, MoveBoid{77, {0, 0}, {0, 0}}).find("77"), std::string::npos);
  EXPECT_NE(refusal(simulation, MoveBoid{0, {0, 0}, {0}}).find("velocity"), std::string::npos);
  EXPECT_NE(refusal(simulation, MovePointer{PointerMode::attract, {}, true}).find("coordinates"),
            std::string::npos);
}

TEST(Commands, EventsInVainAreCounted) {
  ScenarioDef scenario = wrapped_world();
  scenario.run.events = {{1, MoveBoid{5, {0, 0}, {0, 0}}}, {2, MoveBoid{0, {7, 7}, {0, 0}}}};
  Simulation simulation = world_of(scenario, {{{1, 1}}});
  simulation.run(3);
  EXPECT_EQ(simulation.report().commands_in_vain, 1u);
  EXPECT_EQ(position_of(simulation, 0), (Point{7, 7, 0}));
}

}  // namespace
}  // namespace sturnus::test
