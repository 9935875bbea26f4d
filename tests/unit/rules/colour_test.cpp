// Colours that drift toward the neighbours' and stay between 0 and 1.
#include <gtest/gtest.h>

#include "support.h"

namespace sturnus::test {
namespace {

State coloured(const std::vector<Placed>& boids, const std::vector<Point>& colours) {
  State state = state_of(2, boids);
  for (const Point& colour : colours) {
    for (std::size_t channel = 0; channel < 3; ++channel) state.colour[channel].push_back(colour[channel]);
  }
  return state;
}

Point colour_of(const Simulation& simulation, std::uint64_t id) {
  const State& state = simulation.view().state();
  const std::size_t slot = simulation.view().slot(id).value();
  return {state.colour[0][slot], state.colour[1][slot], state.colour[2][slot]};
}

ScenarioDef blending() {
  ScenarioDef scenario = bare();
  scenario.flocks.front().cohesion = {{.weight = 0, .radius = 10}};
  scenario.flocks.front().colour.averaging = 0.5;
  return scenario;
}

TEST(Colour, GoesPartOfTheWayToTheMeanOfTheCohesionRing) {
  Simulation simulation = world_from(blending(), coloured({{{0, 0}}, {{1, 0}}, {{0, 1}}, {{50, 0}}},
                                                          {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}));
  simulation.step();
  const Point c = colour_of(simulation, 0);  // (1, 0, 0) + half of ((0, 0.5, 0.5) - (1, 0, 0))
  EXPECT_NEAR(c[0], 0.5, 1e-6);
  EXPECT_NEAR(c[1], 0.25, 1e-6);
  EXPECT_NEAR(c[2], 0.25, 1e-6);
  EXPECT_EQ(colour_of(simulation, 3), (Point{1, 1, 1}));  // nobody near: it stays
}

TEST(Colour, LooksAtItsOwnFlockOrAtAll) {
  ScenarioDef scenario = blending();
  scenario.flocks.push_back(scenario.flocks.front());
  scenario.flocks.back().name = "others";
  const State state = coloured({{{0, 0}}, {{1, 0}, {}, 1}}, {{0, 0, 0}, {1, 1, 1}});
  Simulation own = world_from(scenario, state);
  own.step();
  EXPECT_EQ(colour_of(own, 0), (Point{0, 0, 0}));
  scenario.flocks.front().colour.of = {Whose::Kind::all, {}};
  Simulation all = world_from(scenario, state);
  all.step();
  EXPECT_NEAR(colour_of(all, 0)[0], 0.5, 1e-6);
}

TEST(Colour, NoiseIsClamped) {
  ScenarioDef scenario = bare();
  scenario.flocks.front().count = 200;
  scenario.flocks.front().colour.start = "random";
  scenario.flocks.front().colour.noise = 0.3;
  Simulation simulation = start(scenario);
  const Point before = colour_of(simulation, 0);
  simulation.step();
  EXPECT_NE(colour_of(simulation, 0), before);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    EXPECT_LE(std::abs(colour_of(simulation, 0)[channel] - before[channel]), 0.3001f);
  }
  simulation.run(100);
  int at_the_edge = 0;
  for (const auto& channel : simulation.view().state().colour) {
    for (const float c : channel) {
      ASSERT_TRUE(c >= 0 && c <= 1) << c;
      at_the_edge += c == 0 || c == 1 ? 1 : 0;
    }
  }
  EXPECT_GT(at_the_edge, 0);
}

TEST(Colour, CostsNothingWhereItDoesNotDrift) {
  ScenarioDef scenario = bare();
  scenario.flocks.front().count = 3;
  EXPECT_TRUE(start(scenario).view().state().colour[0].empty());
}

}  // namespace
}  // namespace sturnus::test
