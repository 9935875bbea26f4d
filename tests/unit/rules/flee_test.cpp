// Fleeing other flocks, in each of its three forms, and the public steering behaviours that it calls.
#include <gtest/gtest.h>
#include <sturnus/steering.h>

#include "rules/rules.h"
#include "support.h"

namespace sturnus::test {
namespace {

void expect_near(const Point& found, const Point& expected) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(found[axis], expected[axis], 1e-6) << "axis " << axis;
}

ScenarioDef fish_and_hawks(SteeringForm form) {
  ScenarioDef scenario = bare();
  scenario.flocks[0].name = "fish";
  scenario.flocks.push_back(scenario.flocks[0]);
  scenario.flocks[1].name = "hawks";
  scenario.flocks[0].max_speed = 1000;
  scenario.flocks[0].flee = {{.from = {"hawks"}, .radius = 10, .weight = 0.5, .form = form}};
  return scenario;
}

// One hawk 5 away at (3, 4), one fish, and one hawk out of sight.
const std::vector<Placed> scene = {{{0, 0}, {1, 0}}, {{3, 4}, {}, 1}, {{1, 1}}, {{0, 10}, {}, 1}};

TEST(Flee, HeadingFormIsTheUnitVectorAwayMinusTheHeading) {
  expect_near(felt_by(fish_and_hawks(SteeringForm::heading), scene), {0.5f * -1.6f, 0.5f * -0.8f, 0});
}

TEST(Flee, HeadingFormAveragesOverThoseInSight) {
  const std::vector<Placed> two = {{{0, 0}, {1, 0}}, {{3, 4}, {}, 1}, {{-2, 0}, {}, 1}};
  // ((-0.6, -0.8) + (1, 0)) / 2 = (0.2, -0.4), minus (1, 0).
  expect_near(felt_by(fish_and_hawks(SteeringForm::heading), two), {0.5f * -0.8f, 0.5f * -0.4f, 0});
}

TEST(Flee, LinearFormIsTheMeanOffsetAway) {
  expect_near(felt_by(fish_and_hawks(SteeringForm::linear), scene), {-1.5f, -2, 0});
}

TEST(Flee, SeekFormIsFullSpeedAwayMinusTheVelocity) {
  ScenarioDef scenario = fish_and_hawks(SteeringForm::seek);
  scenario.flocks[0].max_speed = 20;
  // 20 (-0.6, -0.8) - (1, 0), half of it; the speed stays below 20.
  expect_near(felt_by(scenario, scene), {-6.5f, -8, 0});
}

TEST(Flee, SeekFormWithoutATopSpeedIsRefused) {
  ScenarioDef scenario = fish_and_hawks(SteeringForm::seek);
  scenario.flocks[0].max_speed = infinity;
  EXPECT_NE(to_text(check(scenario)).find("flock.fish.flee.form"), std::string::npos)
      << to_text(check(scenario));
}

TEST(Flee, NobodyInSightIsNoForce) {
  for (const SteeringForm form : {SteeringForm::heading, SteeringForm::seek, SteeringForm::linear}) {
    expect_near(felt_by(fish_and_hawks(form), {{{0, 0}, {1, 0}}, {{30, 4}, {}, 1}, {{1, 1}}}), {});
  }
}

TEST(Flee, AHawkAtTheSamePointGivesNoDirection) {
  const std::vector<Placed> met = {{{5, 5}, {2, 0}}, {{5, 5}, {}, 1}};
  expect_near(felt_by(fish_and_hawks(SteeringForm::linear), met), {});
  expect_near(felt_by(fish_and_hawks(SteeringForm::heading), met), {-0.5f, 0, 0});
}

TEST(Steering, SeekFleeAndFace) {
  expect_near(seek({3, 4, 0}, {1, 0, 0}, 10), {5, 8, 0});
  expect_near(seek({0, 0, 0}, {1, 2, 3}, 10), {-1, -2, -3});
  expect_near(seek({-3, -4, 0}, {1, 0, 0}, 10), {-7, -8, 0});
  expect_near(face({0, 0, 5}, {7, 0, 0}), {-1, 0, 1});
  expect_near(face({0, 0, 0}, {7, 0, 0}), {0, 0, 0});
  expect_near(face({2, 0, 0}, {0, 0, 0}), {1, 0, 0});
  expect_near(heading({0, -3, 4}), {0, -0.6f, 0.8f});
  expect_near(heading({0, 0, 0}), {0, 0, 0});
}

}  // namespace
}  // namespace sturnus::test
