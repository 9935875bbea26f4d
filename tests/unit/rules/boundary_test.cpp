// The edge of the space: open, wrap, turn and bounce, exactly on the line and from far away.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "rules/rules.h"
#include "support.h"

namespace sturnus::test {
namespace {

ScenarioDef box(BoundaryKind kind) {
  ScenarioDef scenario = bare();
  scenario.space.min = {0, 10};
  scenario.space.max = {100, 50};
  scenario.space.boundary.kind = kind;
  return scenario;
}

struct Moved {
  Point position, velocity;
};
Moved after_a_step(const ScenarioDef& scenario, const Point& position, const Point& velocity) {
  Simulation simulation = world_of(scenario, {{position, velocity}});
  simulation.step();
  return {position_of(simulation, 0), velocity_of(simulation, 0)};
}

TEST(Open, LetsGo) {
  EXPECT_EQ(after_a_step(box(BoundaryKind::open), {99, 49}, {5, 6}).position, (Point{104, 55, 0}));
}

TEST(Wrap, ComesOutAtTheOtherSide) {
  EXPECT_EQ(after_a_step(box(BoundaryKind::wrap), {99, 49}, {5, 6}).position, (Point{4, 15, 0}));
  EXPECT_EQ(after_a_step(box(BoundaryKind::wrap), {1, 11}, {-5, -6}).position, (Point{96, 45, 0}));
  EXPECT_EQ(after_a_step(box(BoundaryKind::wrap), {1, 11}, {-5, -6}).velocity, (Point{-5, -6, 0}));
}

TEST(Wrap, ExactlyTheUpperEdgeIsTheLower) {
  EXPECT_EQ(after_a_step(box(BoundaryKind::wrap), {99, 49}, {1, 1}).position, (Point{0, 10, 0}));
  EXPECT_EQ(after_a_step(box(BoundaryKind::wrap), {1, 11}, {-1, -1}).position, (Point{0, 10, 0}));
  EXPECT_EQ(after_a_step(box(BoundaryKind::wrap), {0, 20}, {-1e-9f, 0}).position[0], 0);
}

TEST(Turn, PushesStrictlyInsideTheMargin) {
  ScenarioDef scenario = box(BoundaryKind::turn);
  scenario.space.boundary.margin = {20, 5};
  scenario.space.boundary.strength = 0.5;
  const auto push = [&](float x, float y) { return felt_by(scenario, {{{x, y}}}); };
  EXPECT_EQ(push(50, 30), (Point{0, 0, 0}));
  EXPECT_EQ(push(20, 30), (Point{0, 0, 0}));  // on the line
  EXPECT_EQ(push(80, 45), (Point{0, 0, 0}));
  EXPECT_EQ(push(std::nextafter(20.0f, 0.0f), 30), (Point{0.5f, 0, 0}));
  EXPECT_EQ(push(std::nextafter(80.0f, 90.0f), 30), (Point{-0.5f, 0, 0}));
  EXPECT_EQ(push(5, 12), (Point{0.5f, 0.5f, 0}));
  EXPECT_EQ(push(95, 60), (Point{-0.5f, -0.5f, 0}));  // outside, too
}

TEST(Turn, WithoutAMarginIsANudgeOutside) {
  ScenarioDef scenario = box(BoundaryKind::turn);
  scenario.space.boundary.strength = 2;
  EXPECT_EQ(felt_by(scenario, {{{0, 10}}}), (Point{0, 0, 0}));
  EXPECT_EQ(felt_by(scenario, {{{-1, 51}}}), (Point{2, -2, 0}));
}

TEST(Turn, BetweenCrossedMarginsBothPush) {
  ScenarioDef scenario = box(BoundaryKind::turn);
  scenario.space.boundary.margin = {60};
  scenario.space.boundary.strength = 2;
  EXPECT_EQ(felt_by(scenario, {{{50, 30}}}), (Point{0, 0, 0}));
}

TEST(Turn, IsAnAccelerationOverTheTimeStep) {
  ScenarioDef scenario = box(BoundaryKind::turn);
  scenario.space.boundary.strength = 2;
  scenario.time.dt = 0.25;
  EXPECT_EQ(after_a_step(scenario, {-1, 30}, {0, 0}).velocity, (Point{0.5f, 0, 0}));
}

TEST(Bounce, FoldsThePlaceAndMirrorsTheVelocity) {
  const Moved right = after_a_step(box(BoundaryKind::bounce), {99, 30}, {5, 1});
  EXPECT_EQ(right.position, (Point{96, 31, 0}));
  EXPECT_EQ(right.velocity, (Point{-5, 1, 0}));
  const Moved left_bottom = after_a_step(box(BoundaryKind::bounce), {1, 11}, {-5, -6});
  EXPECT_EQ(left_bottom.position, (Point{4, 15, 0}));
  EXPECT_EQ(left_bottom.velocity, (Point{5, 6, 0}));
}

TEST(Bounce, OnTheWallIsInside) {
  const Moved on_wall = after_a_step(box(BoundaryKind::bounce), {99, 30}, {1, 0});
  EXPECT_EQ(on_wall.position[0], 100);
  EXPECT_EQ(on_wall.velocity[0], 1);
  const Moved next = after_a_step(box(BoundaryKind::bounce), {100, 30}, {1, 0});
  EXPECT_EQ(next.position[0], 99);
  EXPECT_EQ(next.velocity[0], -1);
}

TEST(Bounce, TwiceInAStepKeepsTheVelocity) {
  const Moved twice =
      after_a_step(box(BoundaryKind::bounce), {90, 30}, {120, 0});  // 210: wall at 100, wall at 0
  EXPECT_EQ(twice.position[0], 10);
  EXPECT_EQ(twice.velocity[0], 120);
}

RC_GTEST_PROP(Edges, WrapAndBounceKeepEverybodyInside, ()) {
  Model model;
  model.boundary = *rc::gen::element(BoundaryKind::wrap, BoundaryKind::bounce);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    model.min[axis] = static_cast<float>(*rc::gen::inRange(-3000, 3000)) / 7;
    model.max[axis] = model.min[axis] + static_cast<float>(*rc::gen::inRange(1, 30000)) / 11;
    model.size[axis] = model.max[axis] - model.min[axis];
  }
  Vec<3> position;
  Vec<3> velocity{{1, -2, 3}};
  const float far = *rc::gen::element(1.0f, 1000.0f, 1e6f, 1e15f);
  for (int axis = 0; axis < 3; ++axis)
    position[axis] = far * static_cast<float>(*rc::gen::inRange(-1000, 1000)) /
                     1001;  // sound numbers only: others never come here
  keep_inside(model, position, velocity);
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    RC_ASSERT(position[axis] >= model.min[i] && position[axis] <= model.max[i]);
    RC_ASSERT(model.boundary == BoundaryKind::bounce || position[axis] < model.max[i]);
    RC_ASSERT(std::abs(velocity[axis]) == static_cast<float>(axis + 1));
  }
}

}  // namespace
}  // namespace sturnus::test
