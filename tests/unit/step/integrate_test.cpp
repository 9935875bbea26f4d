// Both integrators with a time step, the speed limits between them, and how observers see the last step.
#include <gtest/gtest.h>

#include "support.h"

namespace sturnus::test {
namespace {

// One boid at (1, 2) with velocity (2, 0) under a constant acceleration of (1, -4).
Simulation pushed(Integrator integrator, double dt, double max_speed = infinity) {
  ScenarioDef scenario = bare();
  scenario.time = {dt, integrator};
  scenario.flocks.front().max_speed = max_speed;
  Simulation simulation = world_of(scenario, {{{1, 2}, {2, 0}}});
  simulation.add_rule("push", 0, [](const View& view, Accelerations& out) {
    for (std::size_t i = 0; i < view.size(); ++i) out.add(i, 1, -4);
  });
  simulation.step();
  return simulation;
}

TEST(Integrator, SemiImplicitMovesByTheNewVelocity) {
  const Simulation simulation = pushed(Integrator::semi_implicit_euler, 0.5);
  EXPECT_EQ(velocity_of(simulation, 0), (Point{2.5f, -2, 0}));
  EXPECT_EQ(position_of(simulation, 0), (Point{2.25f, 1, 0}));
}

TEST(Integrator, ExplicitMovesByTheOldVelocity) {
  const Simulation simulation = pushed(Integrator::explicit_euler, 0.5);
  EXPECT_EQ(velocity_of(simulation, 0), (Point{2.5f, -2, 0}));
  EXPECT_EQ(position_of(simulation, 0), (Point{2, 2, 0}));
}

TEST(Integrator, LimitsTheSpeedBeforeItMoves) {
  const Simulation simulation = pushed(Integrator::semi_implicit_euler, 1, 2.5);  // (3, -4) is 5 long
  EXPECT_EQ(velocity_of(simulation, 0), (Point{1.5f, -2, 0}));
  EXPECT_EQ(position_of(simulation, 0), (Point{2.5f, 0, 0}));
}

TEST(Integrator, ManySmallStepsApproachTheFallingStone) {
  for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::explicit_euler}) {
    ScenarioDef scenario = bare();
    scenario.time = {1.0 / 1024, integrator};
    Simulation simulation = world_of(scenario, {{{0, 0}, {0, 0}}});
    simulation.add_rule("gravity", 0, [](const View&, Accelerations& out) { out.add(0, 0, -10); });
    simulation.run(1024);
    EXPECT_NEAR(velocity_of(simulation, 0)[1], -10, 1e-3);
    EXPECT_NEAR(position_of(simulation, 0)[1], -5, 0.01);
  }
}

TEST(View, KnowsTheLastStep) {
  Simulation simulation = world_of(bare(), {{{0, 0}, {1, 0}}, {{5, 5}, {0, 1}}});
  EXPECT_FALSE(simulation.view().has_previous());
  simulation.step();
  simulation.step();
  ASSERT_TRUE(simulation.view().has_previous());
  const std::size_t slot = simulation.view().slot(1).value();
  EXPECT_EQ(simulation.view().previous_position(slot), (Point{5, 6, 0}));
  EXPECT_EQ(simulation.view().previous_velocity(slot), (Point{0, 1, 0}));
  EXPECT_EQ(simulation.view().step(), 2u);
}

TEST(View, PreviousPlacesAreInTheOrderOfTheView) {
  ScenarioDef scenario;
  scenario.flocks.front().count = 400;
  Simulation simulation = start(scenario);
  for (int step = 0; step < 5; ++step) {
    std::vector<Point> before(400);
    for (std::size_t i = 0; i < 400; ++i) before[simulation.view().id(i)] = simulation.view().position(i);
    simulation.step();
    for (std::size_t i = 0; i < 400; ++i) {
      ASSERT_EQ(simulation.view().previous_position(i), before[simulation.view().id(i)]);
    }
  }
}

TEST(View, ForgetsTheLastStepWhenACommandChangesTheBoids) {
  Simulation simulation = world_of(bare(), {{{0, 0}, {1, 0}}, {{5, 5}, {0, 1}}});
  simulation.step();
  must(simulation.push(EraseBoids{{1, 0}, 0.5}));
  EXPECT_FALSE(simulation.view().has_previous());
  simulation.step();
  must(simulation.push(MoveBoid{1, {0, 0}, {0, 0}}));
  EXPECT_FALSE(simulation.view().has_previous());
  simulation.step();
  must(simulation.push(EraseBoids{{0, 0}, 0.5}));
  must(simulation.push(AddBoids{"boids", 1, {0, 0}, 0}));
  EXPECT_FALSE(simulation.view().has_previous());
}

}  // namespace
}  // namespace sturnus::test
