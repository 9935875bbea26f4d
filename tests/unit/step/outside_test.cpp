// Rules of one's own and accelerations from outside: nobody has to fork the engine to add wind.
#include <gtest/gtest.h>

#include "support.h"

namespace sturnus::test {
namespace {

TEST(AddRule, Wind) {
  ScenarioDef scenario;
  scenario.flocks.front().count = 200;
  Simulation calm = start(scenario), windy = start(scenario);
  windy.add_rule("wind", 0, [](const View& view, Accelerations& accelerations) {
    for (std::size_t i = 0; i < view.size(); ++i) accelerations.add(i, 0.05f, 0);
  });
  calm.run(100);
  windy.run(100);
  const auto mean_x = [](const Simulation& simulation) {
    double sum = 0;
    for (std::size_t i = 0; i < simulation.view().size(); ++i)
      sum += double{simulation.view().velocity(i)[0]};
    return sum / static_cast<double>(simulation.view().size());
  };
  EXPECT_GT(mean_x(windy), mean_x(calm) + 0.5);
  EXPECT_GT(mean_x(windy), 1);
}

TEST(AddRule, SeesTheFlockInTheOrderInWhichItWrites) {
  ScenarioDef scenario;  // its index sorts the boids before the rule is asked
  scenario.flocks.front().count = 300;
  scenario.flocks.front().separation = {};
  scenario.flocks.front().alignment = {};
  scenario.flocks.front().cohesion = {{.weight = 0}};
  scenario.flocks.front().min_speed = 0;
  Simulation simulation = start(scenario);
  simulation.add_rule("stop number 7", 0, [](const View& view, Accelerations& out) {
    const std::size_t slot = view.slot(7).value();
    const Point v = view.velocity(slot);
    out.add(slot, -0.0625f * v[0], -0.0625f * v[1]);
  });
  const State before = simulation.view().state();
  simulation.step();
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double speed = std::hypot(before.velocity[0][i], before.velocity[1][i]);
    const double expected = before.id[i] == 7 ? speed * 0.9375 : speed;
    EXPECT_NEAR(length_of(velocity_of(simulation, before.id[i])), expected, 1e-6);
  }
}

TEST(AddRule, HasItsPlaceInTheOrderOfTerms) {
  ScenarioDef scenario = bare();
  scenario.flocks.front().arbitration = Arbitration::first;
  scenario.flocks.front().cruise = Cruise{.speed = 2, .weight = 1, .priority = 5};
  const auto with_priority = [&](std::int64_t priority) {
    Simulation simulation = world_of(scenario, {{{0, 0}, {1, 0}}});
    simulation.add_rule("up", priority, [](const View&, Accelerations& out) { out.add(0, 0, 3); });
    simulation.step();
    return velocity_of(simulation, 0);
  };
  EXPECT_EQ(with_priority(4), (Point{1, 3, 0}));
  EXPECT_EQ(with_priority(6), (Point{2, 0, 0}));
}

TEST(AddRule, SeveralRulesAddUpAndOutliveCommandsAndRestores) {
  Simulation simulation = world_of(bare(3), {{{0, 0, 0}}});
  simulation.add_rule("x", 0, [](const View&, Accelerations& out) { out.add(0, 1, 0); });
  simulation.add_rule("z", 0, [](const View&, Accelerations& out) { out.add(0, 0, 0, 2); });
  const Snapshot beginning = simulation.snapshot();
  simulation.step();
  EXPECT_EQ(velocity_of(simulation, 0), (Point{1, 0, 2}));
  must(simulation.push(SetParameter{"flock.boids.size", "3"}));
  simulation.step();
  EXPECT_EQ(velocity_of(simulation, 0), (Point{2, 0, 4}));
  simulation.restore(beginning);
  simulation.step();
  EXPECT_EQ(velocity_of(simulation, 0), (Point{1, 0, 2}));
}

TEST(External, IsFeltByItsBoidInTheNextStepOnly) {
  ScenarioDef scenario = bare();
  scenario.flocks.front().cohesion = {{.weight = 0, .radius = 3}};  // so that the index sorts
  Simulation simulation = world_of(scenario, {{{9, 9}}, {{1, 1}}, {{5, 5}}});
  simulation.external().add(simulation.view().slot(0).value(), 1, 2);
  simulation.external().add(simulation.view().slot(2).value(), 0, 4);
  simulation.step();
  EXPECT_EQ(velocity_of(simulation, 0), (Point{1, 2, 0}));
  EXPECT_EQ(velocity_of(simulation, 1), (Point{0, 0, 0}));
  EXPECT_EQ(velocity_of(simulation, 2), (Point{0, 4, 0}));
  simulation.step();
  EXPECT_EQ(velocity_of(simulation, 0), (Point{1, 2, 0}));
}

TEST(External, FindsItsBoidWhetherOrNotTheIndexSorts) {
  ScenarioDef scenario = bare();
  scenario.flocks.front().cohesion = {{.weight = 0, .radius = 3}};
  Simulation simulation = world_of(scenario, {{{9, 9}}, {{1, 1}}, {{5, 5}}});
  simulation.step();
  must(simulation.push(SetParameter{"flock.boids.cohesion.on", "false"}));
  simulation.external().add(simulation.view().slot(0).value(), 1, 2);
  simulation.step();
  EXPECT_EQ(velocity_of(simulation, 0), (Point{1, 2, 0}));
}

TEST(External, IsForgottenWhenBoidsComeOrGo) {
  Simulation simulation = world_of(bare(), {{{0, 0}}, {{5, 5}}});
  simulation.external().add(0, 1, 1);
  must(simulation.push(EraseBoids{{0, 0}, 1}));
  must(simulation.push(AddBoids{"boids", 1, {9, 9}, 0}));
  const Point before = velocity_of(simulation, 2);
  simulation.step();
  EXPECT_EQ(velocity_of(simulation, 1), (Point{0, 0, 0}));
  EXPECT_EQ(velocity_of(simulation, 2), before);
}

}  // namespace
}  // namespace sturnus::test
