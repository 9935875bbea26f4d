// What a boid feels without neighbours: cruise, wander and noise.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/root.h"
#include "rules/rules.h"
#include "support.h"

namespace sturnus::test {
namespace {

TEST(Cruise, AcceleratesAlongTheHeadingTowardItsSpeed) {
  ScenarioDef scenario = bare();
  scenario.flocks.front().cruise = Cruise{.speed = 2, .weight = 0.1};
  const Point fast = felt_by(scenario, {{{0, 0}, {3, 4}}});  // (2 - 5) (0.6, 0.8) 0.1
  EXPECT_NEAR(fast[0], -0.18, 1e-6);
  EXPECT_NEAR(fast[1], -0.24, 1e-6);
  const Point slow = felt_by(scenario, {{{0, 0}, {0, -1}}});
  EXPECT_NEAR(slow[1], -0.1, 1e-6);
  EXPECT_EQ(length_of(felt_by(scenario, {{{0, 0}, {0, 0}}})), 0);
  scenario.flocks.front().cruise->on = false;
  EXPECT_EQ(length_of(felt_by(scenario, {{{0, 0}, {3, 4}}})), 0);
}

template <int D>
void expect_bounded_walk() {
  TermModel term;
  term.amount = 0.3f;
  const Self<D> self(17, {}, {});
  Vec<D> w;
  w[0] = 1;
  double turned = 0;
  for (std::uint64_t step = 0; step < 2000; ++step) {
    const Vec<D> next = wandered<D>(term, self, w, {3, step});
    ASSERT_NEAR(length(next), 1, 1e-6);
    // A step of at most 0.3 on each axis turns a unit vector by at most asin(0.3 sqrt(D)).
    ASSERT_GE(dot(next, w), std::cos(std::asin(0.3 * std::sqrt(D))) - 1e-6);
    turned += 1 - double{dot(next, w)};
    w = next;
  }
  EXPECT_GT(turned, 1);
}

TEST(Wander, IsABoundedWalkOfAUnitVector) {
  expect_bounded_walk<2>();
  expect_bounded_walk<3>();
}

TEST(Wander, ForceIsTheWeightTimesTheNewDirection) {
  ScenarioDef scenario = bare(3);
  scenario.flocks.front().wander = Wander{.rate = 0.3, .weight = 0.05};
  Simulation simulation = world_of(scenario, {{{0, 0, 0}, {0, 0, 0}}});
  for (int step = 0; step < 50; ++step) {
    const Point before = velocity_of(simulation, 0);
    simulation.step();
    const Point after = velocity_of(simulation, 0);
    const State& state = simulation.view().state();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(after[axis] - before[axis], 0.05 * double{state.wander[axis][0]}, 1e-6);
    }
  }
}

TEST(Wander, WithoutRateKeepsItsDirection) {
  ScenarioDef scenario = bare();
  scenario.flocks.front().wander = Wander{.rate = 0, .weight = 1};
  Simulation simulation = world_of(scenario, {{{0, 0}, {0, 0}}});
  const State before = simulation.view().state();
  simulation.run(10);
  EXPECT_NEAR(simulation.view().state().wander[0][0], before.wander[0][0], 1e-6);
}

TEST(Noise, AccelerationIsUniformInACube) {
  ScenarioDef scenario = bare(3);
  scenario.flocks.front().count = 3000;
  scenario.flocks.front().start.max_speed = scenario.flocks.front().start.min_speed = 0;
  scenario.flocks.front().noise = Noise{.acceleration = 0.25};
  Simulation simulation = start(scenario);
  simulation.step();
  for (const auto& column : simulation.view().state().velocity) {
    const auto [low, high] = std::minmax_element(column.begin(), column.end());
    EXPECT_GE(*low, -0.25f);
    EXPECT_LE(*high, 0.25f);
    EXPECT_LT(*low, -0.24f);
    EXPECT_GT(*high, 0.24f);
    double sum = 0;
    for (const float a : column) sum += a;
    EXPECT_NEAR(sum / 3000, 0, 0.014);  // five standard errors of 0.25/sqrt(3)/sqrt(3000)
  }
}

TEST(Noise, IsNewInEveryStepAndForEveryBoid) {
  ScenarioDef scenario = bare();
  scenario.flocks.front().noise = Noise{.acceleration = 1};
  Simulation simulation = world_of(scenario, {{{0, 0}}, {{0, 0}}});
  simulation.step();
  const Point first = velocity_of(simulation, 0);
  EXPECT_NE(first, velocity_of(simulation, 1));
  simulation.step();
  const Point second = velocity_of(simulation, 0);
  EXPECT_NE(first[0], second[0] - first[0]);
}

template <int D>
void expect_turns_within(float eta) {
  double sum_of_angles = 0, largest = 0;
  Vec<D> sum;
  constexpr int count = 4000;
  Vec<D> v;
  v[0] = 3;
  v[1] = -4;
  for (std::uint64_t id = 0; id < count; ++id) {
    const Vec<D> turned = turned_at_random(v, eta, id, {1, 2});
    ASSERT_NEAR(length(turned), 5, 1e-5);
    const double angle = std::acos(std::min(1.0, double{dot(turned, v)} / (double{length(turned)} * 5)));
    ASSERT_LE(angle, double{eta} / 2 + 1e-3);
    largest = std::max(largest, angle);
    sum_of_angles += angle;
    sum += turned;
  }
  EXPECT_GT(largest, 0.49 * double{eta});
  EXPECT_NEAR(sum_of_angles / count, double{eta} / 4, 0.02 * double{eta});
  EXPECT_NEAR(unit(sum)[0], 0.6, 0.03);  // to both sides alike
}

TEST(Noise, TurnKeepsTheSpeedAndStaysWithinHalfOfEta) {
  expect_turns_within<2>(1.0f);
  expect_turns_within<3>(1.0f);
  expect_turns_within<2>(3.0f);
}

TEST(Noise, TurnOfABoidAtRestIsRest) {
  EXPECT_EQ(turned_at_random(Vec<3>{}, 1, 5, {1, 2}), (Vec<3>{}));
  EXPECT_EQ(turned_at_random(Vec<2>{{1, 2}}, 0, 5, {1, 2}), (Vec<2>{{1, 2}}));
}

TEST(Noise, TurnComesAfterTheLimitsAndIsGivenInDegrees) {
  ScenarioDef scenario = bare();
  scenario.flocks.front().noise = Noise{.turn = 60};
  scenario.flocks.front().max_speed = 2;
  for (int seed = 1; seed < 30; ++seed) {
    scenario.seed = seed;
    Simulation simulation = world_of(scenario, {{{0, 0}, {3, 0}}});
    simulation.step();
    const Point v = velocity_of(simulation, 0);
    EXPECT_NEAR(length_of(v), 2, 1e-5);
    EXPECT_LE(std::abs(std::atan2(v[1], v[0])), pi / 6 + 1e-5);
    EXPECT_NE(v[1], 0);
    EXPECT_EQ(position_of(simulation, 0), v);  // the turned velocity moves it
  }
}

}  // namespace
}  // namespace sturnus::test
