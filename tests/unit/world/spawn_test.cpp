// How boids begin: where each region puts them, how fast they are, and that nothing depends on anything but
// the seed and the id.
#include "world/spawn.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support.h"

namespace sturnus::test {
namespace {

struct Beginning {
  ScenarioDef scenario;
  explicit Beginning(int dimensions) : scenario(bare(dimensions)) { scenario.flocks.front().count = 2000; }
  Start& start() { return scenario.flocks.front().start; }
  State state() const { return sturnus::test::start(scenario).view().state(); }
};

TEST(Spawn, FillsTheSpace) {
  for (const int dimensions : {2, 3}) {
    const State state = Beginning(dimensions).state();
    ASSERT_EQ(state.size(), 2000u);
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
      double sum = 0;
      for (const float x : state.position[axis]) {
        EXPECT_GE(x, -1000);
        EXPECT_LE(x, 1000);
        sum += x;
      }
      EXPECT_NEAR(sum / 2000, 0, 65);  // five standard errors of 2000/sqrt(12)/sqrt(2000)
    }
    EXPECT_TRUE(state.position[2].empty() == (dimensions == 2));
  }
}

TEST(Spawn, BoxBallAndRing) {
  for (const int dimensions : {2, 3}) {
    const auto axes = static_cast<std::size_t>(dimensions);
    Beginning box(dimensions);
    box.start().region = StartRegion::box;
    box.start().min = Coordinates(axes, 10.0);
    box.start().max = Coordinates(axes, 30.0);
    const State in_box = box.state();
    for (std::size_t axis = 0; axis < axes; ++axis) {
      for (const float x : in_box.position[axis]) EXPECT_TRUE(x >= 10 && x <= 30) << x;
    }
    Beginning ring(dimensions);
    ring.start().region = StartRegion::ring;
    ring.start().centre = Coordinates(axes, 100.0);
    ring.start().radius = 50;
    ring.start().inner = 40;
    const Simulation in_ring = start(ring.scenario);
    const Point centre{100, 100, dimensions == 3 ? 100.0f : 0.0f};
    for (std::size_t i = 0; i < in_ring.view().size(); ++i) {
      const double d = distance(in_ring.view().position(i), centre);
      EXPECT_TRUE(d >= 39.999 && d <= 50.001) << d;
    }
    ring.start().region = StartRegion::ball;
    const Simulation in_ball = start(ring.scenario);
    int inside = 0;
    for (std::size_t i = 0; i < in_ball.view().size(); ++i) {
      inside += distance(in_ball.view().position(i), centre) < 25 ? 1 : 0;
    }
    EXPECT_NEAR(inside / 2000.0, dimensions == 3 ? 0.125 : 0.25, 0.05);
  }
}

TEST(Spawn, AThinRingTakesNoLongerThanAThickOne) {
  Beginning ring(3);
  ring.start().region = StartRegion::ring;
  ring.start().radius = 50;
  for (const double inner : {50.0, 50.0 - 4e-6, 49.999}) {
    ring.start().inner = inner;
    const Simulation simulation = start(ring.scenario);
    for (std::size_t i = 0; i < simulation.view().size(); ++i) {
      EXPECT_NEAR(length_of(simulation.view().position(i)), 50, 2e-3);
    }
  }
}

TEST(Spawn, SpeedsAndHeadings) {
  Beginning some(2);
  some.start().min_speed = 3;
  some.start().max_speed = 5;
  some.start().heading = {0, 2};
  const Simulation simulation = start(some.scenario);
  double sum = 0;
  for (std::size_t i = 0; i < simulation.view().size(); ++i) {
    const Point v = simulation.view().velocity(i);
    EXPECT_EQ(v[0], 0);
    EXPECT_TRUE(v[1] >= 3 && v[1] <= 5) << v[1];
    sum += v[1];
  }
  EXPECT_NEAR(sum / 2000, 4, 0.07);
}

TEST(Spawn, DependsOnSeedAndIdAlone) {
  Beginning first(3), second(3);
  second.scenario.flocks.front().count = 3000;
  const Simulation few = start(first.scenario), many = start(second.scenario);
  for (std::uint64_t id = 0; id < 2000; id += 97) {
    EXPECT_EQ(position_of(few, id), position_of(many, id));
    EXPECT_EQ(velocity_of(few, id), velocity_of(many, id));
  }
  second.scenario.seed = 2;
  EXPECT_NE(position_of(few, 5), position_of(start(second.scenario), 5));
}

TEST(Spawn, FlocksFollowOneAnotherAndShareOneSpaceOfIds) {
  ScenarioDef scenario = bare();
  scenario.flocks.push_back(scenario.flocks.front());
  scenario.flocks[0].count = 3;
  scenario.flocks[1].count = 2;
  scenario.flocks[1].name = "others";
  const State state = start(scenario).view().state();
  EXPECT_EQ(state.id, (std::vector<std::uint64_t>{0, 1, 2, 3, 4}));
  EXPECT_EQ(state.flock, (std::vector<std::uint8_t>{0, 0, 0, 1, 1}));
  EXPECT_EQ(state.next_id, 5u);
}

TEST(Spawn, TablesKeepTheirIdsAndGetWhatTheyLack) {
  ScenarioDef scenario = bare();
  scenario.flocks.front().wander = Wander{};
  scenario.flocks.front().colour.start = "#ff8000";
  State table = state_of(2, {{{1, 2}}, {{3, 4}}});
  table.id = {40, 7};
  const Simulation simulation = world_from(scenario, table);
  const State& state = simulation.view().state();
  EXPECT_EQ(state.id, (std::vector<std::uint64_t>{40, 7}));
  EXPECT_EQ(state.next_id, 41u);
  EXPECT_NEAR(std::hypot(state.wander[0][1], state.wander[1][1]), 1, 1e-6);
  EXPECT_TRUE(state.colour[0].empty());  // a colour that never changes is no part of the state
}

TEST(Spawn, StartColours) {
  ScenarioDef scenario = bare();
  scenario.flocks.front().count = 500;
  scenario.flocks.front().colour.start = "#ff8000";
  scenario.flocks.front().colour.noise = 0.1;
  const State named = start(scenario).view().state();
  EXPECT_EQ(named.colour[0][3], 1.0f);
  EXPECT_EQ(named.colour[1][3], 128 / 255.0f);
  EXPECT_EQ(named.colour[2][3], 0.0f);
  scenario.flocks.front().colour.start = "random";
  const State random = start(scenario).view().state();
  double low = 1, high = 0;
  for (const float c : random.colour[1]) {
    low = std::min(low, double{c});
    high = std::max(high, double{c});
  }
  EXPECT_TRUE(low >= 0 && low < 0.3 && high > 0.7 && high <= 1) << low << " to " << high;
}

}  // namespace
}  // namespace sturnus::test
