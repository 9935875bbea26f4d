// The pointer: who is within its range feels it while it is pressed, in each of its forms.
#include <gtest/gtest.h>

#include "support.h"

namespace sturnus::test {
namespace {

ScenarioDef world_with(SteeringForm form) {
  ScenarioDef scenario = bare();
  scenario.pointer = {.weight = 0.5, .radius = 10, .form = form, .priority = 0};
  scenario.flocks.front().max_speed = 100;
  return scenario;
}

Point felt(const ScenarioDef& scenario, const MovePointer& pointer, const Placed& boid) {
  Simulation simulation = world_of(scenario, {boid});
  must(simulation.push(pointer));
  simulation.step();
  const Point v = velocity_of(simulation, 0);
  return {v[0] - boid.velocity[0], v[1] - boid.velocity[1], 0};
}

void expect_near(const Point& found, const Point& expected) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(found[axis], expected[axis], 1e-5) << "axis " << axis;
}

const MovePointer attract{PointerMode::attract, {3, 4}, true};
const MovePointer repel{PointerMode::repel, {3, 4}, true};
const Placed boid{{0, 0}, {1, 0}};

TEST(Pointer, AttractsAndRepelsInEveryForm) {
  expect_near(felt(world_with(SteeringForm::heading), attract, boid), {0.5f * -0.4f, 0.5f * 0.8f, 0});
  expect_near(felt(world_with(SteeringForm::heading), repel, boid), {0.5f * -1.6f, 0.5f * -0.8f, 0});
  expect_near(felt(world_with(SteeringForm::linear), attract, boid), {1.5f, 2, 0});
  expect_near(felt(world_with(SteeringForm::linear), repel, boid), {-1.5f, -2, 0});
  expect_near(felt(world_with(SteeringForm::seek), attract, boid),
              {29.5f, 40, 0});  // 100 (0.6, 0.8) - (1, 0), half
}

TEST(Pointer, IsFeltOnlyWhilePressedAndInRange) {
  expect_near(felt(world_with(SteeringForm::linear), {PointerMode::attract, {3, 4}, false}, boid), {});
  expect_near(felt(world_with(SteeringForm::linear), {PointerMode::attract, {11, 0}, true}, boid), {});
  expect_near(felt(world_with(SteeringForm::linear), {PointerMode::attract, {10, 0}, true}, boid), {5, 0, 0});
}

TEST(Pointer, ThatIsALineIsFeltFromItsNearestPoint) {
  ScenarioDef scenario = world_with(SteeringForm::linear);
  scenario.space.dimensions = 3;
  scenario.space.min = {-900, -900, -900};
  scenario.space.max = {900, 900, 900};
  expect_near(felt(scenario, {PointerMode::attract, {3, 4, 700}, true, {0, 0, 1}}, boid), {1.5f, 2, 0});
}

TEST(Pointer, AtTheBoidItselfHasNoDirection) {
  expect_near(felt(world_with(SteeringForm::heading), {PointerMode::attract, {0, 0}, true}, boid), {});
  expect_near(felt(world_with(SteeringForm::linear), {PointerMode::attract, {0, 0}, true}, boid), {});
}

TEST(Pointer, ReachesOverTheSeam) {
  ScenarioDef scenario = world_with(SteeringForm::linear);
  scenario.space.min = {0, 0};
  scenario.space.max = {100, 100};
  scenario.space.boundary.kind = BoundaryKind::wrap;
  expect_near(felt(scenario, {PointerMode::attract, {98, 50}, true}, {{1, 50}, {0, 0}}), {-1.5f, 0, 0});
}

TEST(Pointer, SeekFormWithoutATopSpeedIsRefused) {
  ScenarioDef scenario = world_with(SteeringForm::seek);
  scenario.flocks.front().max_speed = infinity;
  EXPECT_NE(to_text(check(scenario)).find("pointer.form"), std::string::npos) << to_text(check(scenario));
}

}  // namespace
}  // namespace sturnus::test
