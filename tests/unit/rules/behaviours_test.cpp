// Steering behaviours in the engine: each term is its public function, over the right others.
#include <gtest/gtest.h>
#include <sturnus/steering.h>

#include "support.h"

namespace sturnus::test {
namespace {

void expect_near(const Point& found, const Point& expected) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(found[axis], expected[axis], 1e-4) << "axis " << axis;
}

// The steered boid's flock and another; its top speed never binds.
ScenarioDef two_flocks(int dimensions = 2) {
  ScenarioDef scenario = bare(dimensions);
  scenario.flocks[0].name = "birds";
  scenario.flocks[0].max_speed = 50;
  scenario.flocks[0].count = 2;
  scenario.flocks.push_back(scenario.flocks[0]);
  scenario.flocks[1].name = "others";
  return scenario;
}

TEST(Behaviours, PursuitTakesTheNearestQuarryAndTheTimeThatItsPredictionSays) {
  ScenarioDef scenario = two_flocks();
  scenario.flocks[0].pursue.emplace();
  Pursuit& pursue_table = *scenario.flocks[0].pursue;
  pursue_table.of = {"others"};
  pursue_table.weight = 0.5;
  pursue_table.time = 3;
  pursue_table.per_length = 0.25;
  const std::vector<Placed> boids = {{{0, 0}, {1, 2}}, {{30, 40}, {-5, 1}, 1}, {{-60, 0}, {}, 1}, {{2, 2}}};
  const Vector o = {30, 40, 0}, quarry = {-5, 1, 0}, own = {1, 2, 0};
  const auto half = [](Vector v) { return Point{0.5f * v[0], 0.5f * v[1], 0.5f * v[2]}; };
  pursue_table.prediction = Prediction::constant;
  expect_near(felt_by(scenario, boids), half(pursue(o, quarry, 3, own, 50)));
  pursue_table.prediction = Prediction::distance;
  expect_near(felt_by(scenario, boids), half(pursue(o, quarry, 12.5f, own, 50)));
  pursue_table.prediction = Prediction::intercept;
  expect_near(felt_by(scenario, boids), half(pursue(o, quarry, *interception_time(o, quarry, 50), own, 50)));
  pursue_table.offset = {-7, 3};
  pursue_table.prediction = Prediction::constant;
  pursue_table.slowing = 200;
  expect_near(felt_by(scenario, boids), half(pursue_offset(o, quarry, {-7, 3, 0}, 3, own, 50, 200)));
  pursue_table.radius = 49;
  expect_near(felt_by(scenario, boids), {});
}

TEST(Behaviours, EvasionIsPursuitsFleeAcrossTheSeamToo) {
  ScenarioDef scenario = two_flocks();
  scenario.space.boundary.kind = BoundaryKind::wrap;
  scenario.flocks[0].evade.emplace();
  scenario.flocks[0].evade->of = {"others"};
  scenario.flocks[0].evade->prediction = Prediction::constant;
  scenario.flocks[0].evade->time = 2;
  // 20 to the left over the seam, though 1980 to the right within the space.
  const std::vector<Placed> boids = {{{-990, 0}, {1, 0}}, {{990, 0}, {3, 4}, 1}};
  expect_near(felt_by(scenario, boids), evade({-20, 0, 0}, {3, 4, 0}, 2, {1, 0, 0}, 50));
}

TEST(Behaviours, OfTwoEquallyNearTheLowestIdIsPursuedWhateverTheOrder) {
  ScenarioDef scenario = two_flocks();
  scenario.flocks[0].pursue.emplace();
  scenario.flocks[0].pursue->of = {"others"};
  const std::vector<Placed> boids = {{{0, 0}, {}}, {{0, 10}, {}, 1}, {{10, 0}, {}, 1}};
  expect_near(felt_by(scenario, boids), {0, 50, 0});
  scenario.flocks[0].cohesion = {Cohesion{.weight = 0, .radius = 100}};  // an index that sorts them
  expect_near(felt_by(scenario, boids), {0, 50, 0});
}

// The flock "birds" hides from "others" among these obstacles.
ScenarioDef hiding_among(const ObstacleDef& obstacles, int dimensions = 2) {
  ScenarioDef scenario = two_flocks(dimensions);
  scenario.obstacles = {obstacles};
  Hide hide;
  hide.from = {"others"};
  hide.reach = 100;
  hide.margin = 3;
  hide.slowing = 200;
  hide.time = 2;
  scenario.flocks[0].hide = hide;
  return scenario;
}

TEST(Behaviours, HidingIsThePublicFunctionOverTheObstaclesInReach) {
  const ScenarioDef scenario = hiding_among({{{40, 10, 5}, {-30, 50, 8}, {0, -150, 60}}, {}, {}, {}});
  const std::vector<Placed> boids = {{{0, 0}, {1, 2}}, {{70, -20}, {-5, 1}, 1}, {{-200, 0}, {}, 1}};
  const std::vector<Ball> balls = {{{40, 10, 0}, 5}, {{-30, 50, 0}, 8}, {{0, -150, 0}, 60}};
  expect_near(felt_by(scenario, boids), hide(balls, {70, -20, 0}, 3, {1, 2, 0}, 50, 200));
  ScenarioDef far = scenario;
  far.flocks[0].hide->reach = 36;  // to the first surface it is 36.2, to the second 50.3
  expect_near(felt_by(far, boids), evade({70, -20, 0}, {-5, 1, 0}, 2, {1, 2, 0}, 50));
  far.flocks[0].hide->reach = 37;
  expect_near(felt_by(far, boids), hide(std::span(balls).first(1), {70, -20, 0}, 3, {1, 2, 0}, 50, 200));
  far.flocks[0].hide->radius = 70;
  expect_near(felt_by(far, boids), {});  // nobody to hide from is seen
}

TEST(Behaviours, HidingKnowsSpaceAndTheSeam) {
  const std::vector<Ball> ball = {{{-30, 5, 10}, 4}};
  ScenarioDef scenario = hiding_among({{{980, 5, 10, 4}}, {}, {}, {}}, 3);
  scenario.space.boundary.kind = BoundaryKind::wrap;
  // All by their nearest images: the ball 30 to the left over the seam, the hunter 60.
  const std::vector<Placed> boids = {{{-990, 0, 0}, {1, 0, 2}}, {{950, 0, 0}, {3, 4, 0}, 1}};
  expect_near(felt_by(scenario, boids), hide(ball, {-60, 0, 0}, 3, {1, 0, 2}, 50, 200));
}

TEST(Behaviours, BoxesHideAsTheBallAroundThemAndPlanesNobody) {
  const std::vector<Placed> boids = {{{0, 0}, {1, 2}}, {{70, 0}, {-5, 1}, 1}};
  const std::vector<Ball> ball = {{{30, 10, 0}, 5}};
  expect_near(felt_by(hiding_among({{}, {{27, 6, 33, 14}}, {}, {}}), boids),
              hide(ball, {70, 0, 0}, 3, {1, 2, 0}, 50, 200));
  expect_near(felt_by(hiding_among({{}, {}, {{0, -20, 0, 1}}, {}}), boids),
              evade({70, 0, 0}, {-5, 1, 0}, 2, {1, 2, 0}, 50));
}

TEST(Behaviours, PathAndWallAreTakenByTheNearestImage) {
  ScenarioDef scenario = two_flocks();
  scenario.space.boundary.kind = BoundaryKind::wrap;
  FollowPath path;
  path.points = {{900, -50}, {900, 50}};
  path.radius = 5;
  path.ahead = 8;
  path.time = 1;
  scenario.flocks[0].follow_path = path;
  const std::vector<Placed> boids = {{{-950, 0}, {1, 2}}};
  const std::vector<Vector> corners = {{900, -50, 0}, {900, 50, 0}};
  expect_near(felt_by(scenario, boids), follow_path({corners}, 5, 8, 1, {1050, 0, 0}, {1, 2, 0}, 50));
  scenario.flocks[0].follow_path.reset();
  FollowWall wall;
  wall.points = path.points;
  wall.distance = 20;
  wall.radius = 1;
  wall.ahead = 8;
  wall.time = 1;
  scenario.flocks[0].follow_wall = wall;
  expect_near(felt_by(scenario, boids), follow_wall({corners}, 20, 1, 8, 1, {1050, 0, 0}, {1, 2, 0}, 50));
}

TEST(Behaviours, FlowsAreLookedUpAhead) {
  ScenarioDef scenario = two_flocks();
  FollowFlow flow;
  flow.centre = {10, 20};
  flow.core = 5;
  flow.speed = 3;
  flow.time = 2;
  flow.rate = 0.5;
  flow.velocity = {7, 8};
  scenario.flocks[0].flow = flow;
  const std::vector<Placed> boids = {{{20, 30}, {1, 2}}};  // will be at (22, 34), (12, 14) from the centre
  const Vector whirl = vortex({12, 14, 0}, 3, 5);
  expect_near(felt_by(scenario, boids), {whirl[0] - 1, whirl[1] - 2, 0});
  scenario.flocks[0].flow->kind = FlowKind::shear;
  expect_near(felt_by(scenario, boids), {6, -2, 0});
  scenario.flocks[0].flow->kind = FlowKind::uniform;
  expect_near(felt_by(scenario, boids), {6, 6, 0});
}

TEST(Behaviours, LeadersAreFollowed) {
  ScenarioDef scenario = two_flocks(3);
  scenario.flocks[0].follow_leader.emplace();
  scenario.flocks[0].follow_leader->leader = "others";
  const std::vector<Placed> boids = {{{0, 0, 0}, {1, 0, 2}}, {{10, 20, 70}, {1, 1, 1}, 1}};
  expect_near(felt_by(scenario, boids), follow_leader({10, 20, 70}, {1, 1, 1}, 20, 15, {1, 0, 2}, 50, 30));
}

TEST(Behaviours, CollisionsAreAvoidedWithWhomComesTooNearFirst) {
  ScenarioDef scenario = two_flocks();
  scenario.flocks[0].avoid_collisions.emplace();
  AvoidCollisions& avoid = *scenario.flocks[0].avoid_collisions;
  avoid.radius = 100;
  avoid.gap = 5;
  avoid.time = 40;
  // Own goes right at 1. The nearest one goes alike; the next passes in 20 steps, 2 to the left; the third in
  // 10, 3 to the right.
  const std::vector<Placed> boids = {
      {{0, 0}, {1, 0}}, {{3, 0}, {1, 0}, 1}, {{40, 2}, {-1, 0}, 1}, {{40, -3}, {-3, 0}, 1}};
  expect_near(felt_by(scenario, boids), {0, 1, 0});
  avoid.gap = 2.5;
  expect_near(felt_by(scenario, boids), {0, -1, 0});
  avoid.time = 19;
  expect_near(felt_by(scenario, boids), {});
  avoid.time = 40;
  avoid.radius = 39;
  expect_near(felt_by(scenario, boids), {});
}

TEST(Behaviours, QueuesBrakeForTheNearestAhead) {
  ScenarioDef scenario = two_flocks();
  scenario.flocks[0].queue.emplace();
  scenario.flocks[0].queue->distance = 20;
  scenario.flocks[0].queue->angle = 60;
  const std::vector<Placed> boids = {
      {{0, 0}, {2, 0}}, {{10, 1}, {}, 1}, {{15, 0}, {}}, {{-3, 0}, {}}, {{0, 4}, {}}};
  const float gap = std::sqrt(101.0f);
  expect_near(felt_by(scenario, boids), {-2 * (1 - gap / 20), 0, 0});
}

TEST(Behaviours, SwitchedOffTheyAskForNothing) {
  ScenarioDef scenario = two_flocks();
  scenario.flocks[0].queue.emplace();
  scenario.flocks[0].queue->on = false;
  scenario.flocks[0].pursue.emplace();
  scenario.flocks[0].pursue->of = {"others"};
  scenario.flocks[0].pursue->on = false;
  expect_near(felt_by(scenario, {{{0, 0}, {2, 0}}, {{10, 1}, {}, 1}}), {});
}

std::string problems_of(const ScenarioDef& scenario) {
  return to_text(check(scenario));
}

TEST(Behaviours, WhatIsWrongIsSaidInASentence) {
  ScenarioDef scenario = two_flocks();
  scenario.flocks[0].pursue.emplace();
  EXPECT_NE(problems_of(scenario).find("flock.birds.pursue.of"), std::string::npos);
  scenario.flocks[0].pursue->of = {"other"};
  EXPECT_NE(problems_of(scenario).find("did you mean \"others\""), std::string::npos);
  scenario.flocks[0].pursue->of = {"others"};
  EXPECT_EQ(problems_of(scenario), "");
  scenario.flocks[1].count = 257;
  EXPECT_NE(problems_of(scenario).find("there may be 256"), std::string::npos);
  scenario.flocks[1].count = 2;
  scenario.flocks[0].pursue->offset = {1, 2, 3};
  EXPECT_NE(problems_of(scenario).find("pursue.offset"), std::string::npos);
  scenario.flocks[0].pursue->offset = {};
  scenario.flocks[0].max_speed = infinity;
  EXPECT_NE(problems_of(scenario).find("is infinite"), std::string::npos);
  scenario.flocks[0].max_speed = 5;
  scenario.flocks[0].follow_path.emplace();
  EXPECT_NE(problems_of(scenario).find("at least two corners"), std::string::npos);
  scenario.flocks[0].follow_path->points = {{1, 2}, {1, 2, 3}};
  EXPECT_NE(problems_of(scenario).find("every corner must have 2"), std::string::npos);
  scenario.flocks[0].follow_path->points = {{1, 2}, {5, 2}};
  scenario.flocks[0].follow_leader.emplace();
  EXPECT_NE(problems_of(scenario).find("follow_leader.leader"), std::string::npos);
  scenario.flocks[0].follow_leader->leader = "others";
  scenario.flocks[0].hide.emplace();
  EXPECT_NE(problems_of(scenario).find("flock.birds.hide.from: names nobody"), std::string::npos);
  scenario.flocks[0].hide->from = {"other"};
  EXPECT_NE(problems_of(scenario).find("hide.from: there is no flock"), std::string::npos)
      << problems_of(scenario);
  scenario.flocks[0].hide->from = {"others"};
  scenario.flocks[0].flow.emplace();
  scenario.flocks[0].flow->centre = {1};
  EXPECT_NE(problems_of(scenario).find("flow.centre"), std::string::npos);
}

}  // namespace
}  // namespace sturnus::test
