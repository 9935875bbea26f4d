// The hunt as a term: averages, focus, the five aims; interception itself is tested with pursuit.
#include <gtest/gtest.h>

#include <map>

#include "support.h"

namespace sturnus::test {
namespace {

/// Hunters are flock 0, prey flock 1; nobody feels anything but the hunt.
ScenarioDef hunters_and_prey(const Hunt& hunt, int dimensions = 2) {
  ScenarioDef scenario = bare(dimensions);
  scenario.flocks.push_back(scenario.flocks.front());
  scenario.flocks[0].name = "hunters";
  scenario.flocks[1].name = "prey";
  scenario.flocks[0].max_speed = 10;
  scenario.flocks[1].max_speed = 100;
  scenario.flocks[0].hunt = hunt;
  scenario.flocks[0].hunt->prey = {"prey"};
  return scenario;
}

TEST(Hunt, AverageIsTheMeanDirectionOfThePreyInViewMinusTheOwnHeading) {
  const Hunt hunt{.sight = 50, .weight = 0.5};
  // In view: at (0, 30) and (40, 0); behind the radius, and a fellow hunter, nobody.
  const std::vector<Placed> boids = {{{0, 0}, {0, 3}, 0},
                                     {{0, 30}, {1, 0}, 1},
                                     {{40, 0}, {0, 1}, 1},
                                     {{0, -51}, {0, 1}, 1},
                                     {{5, 5}, {0, 1}, 0}};
  const Point felt = felt_by(hunters_and_prey(hunt), boids);
  EXPECT_NEAR(felt[0], 0.5 * (0.5 - 0), 1e-6);
  EXPECT_NEAR(felt[1], 0.5 * (0.5 - 1), 1e-6);
}

TEST(Hunt, SeesWithinItsFieldOfViewOnly) {
  const Hunt hunt{.sight = 50, .weight = 1, .field_of_view = 90};
  for (const auto& [x, y, seen] :
       std::vector<std::tuple<float, float, bool>>{{10, 20, true}, {20, 10, false}, {0, -10, false}}) {
    const Point felt = felt_by(hunters_and_prey(hunt), {{{0, 0}, {0, 3}, 0}, {{x, y}, {0, 0}, 1}});
    EXPECT_EQ(length_of(felt) > 0, seen) << x << ", " << y;
  }
}

TEST(Hunt, SwitchedOffNobodyIsHunted) {
  Hunt hunt{.sight = 50, .weight = 1};
  hunt.on = false;
  ScenarioDef scenario = hunters_and_prey(hunt);
  scenario.flocks[0].body_radius = 100;
  Simulation world = world_of(scenario, {{{0, 0}, {0, 3}, 0}, {{10, 0}, {0, 0}, 1}});
  world.step();
  EXPECT_EQ(world.view().size(), 2u);
  EXPECT_EQ(velocity_of(world, 0), (Point{0, 3, 0}));
}

/// |target - v| for a hunter that goes at full speed toward `target`, from the model's words, in double.
std::array<double, 2> full_speed_toward(double x, double y, double speed, double vx, double vy) {
  const double size = std::hypot(x, y);
  return {x / size * speed - vx, y / size * speed - vy};
}

TEST(Hunt, EveryAimForeseesThePreyInItsOwnWay) {
  // Prey at (30, 40), 50 away, moving (3, -1); the hunter moves (0, 2) and can reach 10.
  const double s = 10, x = 30, y = 40, vx = 3, vy = -1;
  // (v² - s²) T² + 2 o·v T + o² = 0
  const double a = vx * vx + vy * vy - s * s, b = 2 * (x * vx + y * vy), c = x * x + y * y;
  const double catching = (-b - std::sqrt(b * b - 4 * a * c)) / (2 * a);
  ASSERT_NEAR(std::hypot(x + vx * catching, y + vy * catching), s * catching, 1e-9);
  const std::map<HuntAim, double> ahead = {{HuntAim::seek, 0},
                                           {HuntAim::constant, 7},
                                           {HuntAim::distance, 0.3 * 50},
                                           {HuntAim::intercept, catching}};
  for (const auto& [aim, time] : ahead) {
    const Hunt hunt{
        .sight = 60, .choose = HuntChoice::nearest, .aim = aim, .time = 7, .factor = 0.3, .weight = 1};
    const Point felt = felt_by(hunters_and_prey(hunt), {{{0, 0}, {0, 2}, 0}, {{30, 40}, {3, -1}, 1}});
    const auto wanted = full_speed_toward(x + vx * time, y + vy * time, s, 0, 2);
    EXPECT_NEAR(felt[0], wanted[0], 2e-5) << static_cast<int>(aim);
    EXPECT_NEAR(felt[1], wanted[1], 2e-5) << static_cast<int>(aim);
  }
}

/// Whom boid 0 has in focus.
std::uint64_t focus_of(const Simulation& world) {
  return world.view().state().life.focus[world.view().slot(0).value()];
}

TEST(Focus, StaysUntilAnotherIsLessThanHalfAsFar) {
  const Hunt hunt{.sight = 100, .choose = HuntChoice::nearest, .weight = 0};
  Simulation world =
      world_of(hunters_and_prey(hunt), {{{0, 0}, {0, 0}, 0}, {{40, 0}, {0, 0}, 1}, {{0, 50}, {0, 0}, 1}});
  world.step();
  EXPECT_EQ(focus_of(world), 1u);
  must(world.push(MoveBoid{2, {0, 21}, {0, 0}}));
  world.step();
  EXPECT_EQ(focus_of(world), 1u) << "21 is nearer than 40, but not much";
  must(world.push(MoveBoid{2, {0, 19}, {0, 0}}));
  world.step();
  EXPECT_EQ(focus_of(world), 2u);
  must(world.push(MoveBoid{2, {0, 101}, {0, 0}}));
  world.step();
  EXPECT_EQ(focus_of(world), 1u) << "the other is out of sight";
  must(world.push(EraseBoids{{40, 0}, 1}));
  world.step();
  EXPECT_EQ(focus_of(world), nobody);
}

TEST(Focus, OfTwoEquallyNearTheLowerIdIsTaken) {
  const Hunt hunt{.sight = 100, .choose = HuntChoice::nearest, .weight = 0};
  Simulation world =
      world_of(hunters_and_prey(hunt), {{{0, 0}, {0, 0}, 0}, {{40, 0}, {0, 0}, 1}, {{0, 40}, {0, 0}, 1}});
  world.step();
  EXPECT_EQ(focus_of(world), 1u);
}

// With confusion k, n prey in view and a step of dt the focus slips with probability k·n·dt: 0.02·5·0.5.
TEST(Focus, SlipsAsOftenAsConfusionSaysAndToEverybodyAlike) {
  Hunt hunt{.sight = 100, .choose = HuntChoice::nearest, .confusion = 0.02, .weight = 0};
  ScenarioDef scenario = hunters_and_prey(hunt);
  scenario.time.dt = 0.5;
  Simulation world = world_of(scenario, {{{0, 0}, {0, 0}, 0},
                                         {{40, 0}, {0, 0}, 1},
                                         {{0, 41}, {0, 0}, 1},
                                         {{-42, 0}, {0, 0}, 1},
                                         {{0, -43}, {0, 0}, 1},
                                         {{30, 31}, {0, 0}, 1}});
  world.step();
  std::map<std::uint64_t, int> held;
  int slips = 0;
  constexpr int steps = 40000;
  for (int step = 0; step < steps; ++step) {
    const std::uint64_t before = focus_of(world);
    world.step();
    slips += focus_of(world) != before ? 1 : 0;
    ++held[focus_of(world)];
  }
  EXPECT_NEAR(slips, 0.05 * steps, 6 * std::sqrt(0.05 * 0.95 * steps));
  ASSERT_EQ(held.size(), 5u);
  for (const auto& [id, count] : held) EXPECT_NEAR(count, steps / 5, steps / 25) << id;
}

}  // namespace
}  // namespace sturnus::test
