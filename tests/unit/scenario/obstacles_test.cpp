// Obstacles in scenario files: read, printed, set, drawn at random, and refused with a sentence.
#include "scenario/obstacles.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/vec.h"
#include "support.h"

namespace sturnus::test {
namespace {

constexpr const char* text = R"(
[space]
min = [0, 0]
max = [100, 80]
boundary = "bounce"
solid = true
[[obstacle]]
spheres = [[10, 20, 5], [30, 40.5, 2.25]]
boxes = [[50, 50, 60, 70]]
[[obstacle]]
planes = [[0, 3, 0, 2]]
random = { count = 3, radius = [1, 2], keep_apart = 4 }
[[flock]]
count = 10
avoid_obstacles = { weight = 30, look_ahead = 8, clearance = 0.25, priority = 1 }
body_radius = 0.5
)";

ScenarioDef read(const std::string& toml) {
  return take(parse_scenario(toml, "rocks.toml"));
}

std::string errors_of(const std::string& obstacle, const std::string& space = "boundary = \"bounce\"") {
  const auto result = parse_scenario(
      "[space]\nmin = [0, 0]\nmax = [100, 80]\n" + space + "\n[[obstacle]]\n" + obstacle + "\n[[flock]]\n",
      "rocks.toml");
  return result ? "" : result.error();
}

TEST(ObstacleText, BecomesObstaclesInOrder) {
  const auto found = take(obstacles_of(read(text)));
  ASSERT_EQ(found.size(), 7u);
  EXPECT_EQ(found[0].kind, ObstacleKind::sphere);
  EXPECT_EQ(found[1].at, (Point{30, 40.5f, 0}));
  EXPECT_EQ(found[1].radius, 2.25f);
  EXPECT_EQ(found[2].kind, ObstacleKind::box);
  EXPECT_EQ(found[2].at, (Point{55, 60, 0}));
  EXPECT_EQ(found[2].half, (Point{5, 10, 0}));
  EXPECT_EQ(found[3].kind, ObstacleKind::plane);
  EXPECT_EQ(found[3].normal, (Point{0, 1, 0}));
  EXPECT_EQ(found[6].kind, ObstacleKind::sphere);
}

TEST(ObstacleText, IsPrintedAndReadBack) {
  const ScenarioDef scenario = read(text);
  const std::string printed = to_toml(scenario);
  EXPECT_NE(printed.find("\n[[obstacle]]\nspheres = [[10, 20, 5], [30, 40.5, 2.25]]\n"), std::string::npos)
      << printed;
  const ScenarioDef again = read(printed);
  EXPECT_EQ(to_toml(again), printed);
  EXPECT_EQ(take(obstacles_of(again)), take(obstacles_of(scenario)));
}

TEST(ObstacleText, CanBeSetByItsPath) {
  ScenarioDef scenario = read(text);
  set(scenario, "obstacle.0.spheres", "[[1, 2, 3]]");
  EXPECT_EQ(take(get_parameter(scenario, "obstacle.0.spheres")), "[[1, 2, 3]]");
  set(scenario, "obstacle.1.random.count", "5");
  EXPECT_EQ(take(obstacles_of(scenario)).size(), 8u);
  ScenarioDef empty;
  set(empty, "obstacle.spheres", "[[1, 2, 3], [4, 5, 6]]");
  EXPECT_EQ(take(obstacles_of(empty)).size(), 2u);
  set(empty, "flock.boids.avoid_obstacles.form", "heading");
  EXPECT_EQ(empty.flocks.front().avoid_obstacles->form, ObstacleForm::heading);
}

TEST(ObstacleText, CannotBeSetWhileAFlockRuns) {
  Simulation simulation = start(read(text));
  EXPECT_FALSE(simulation.push(SetParameter{"obstacle.0.spheres", "[[1, 2, 3]]"}));
}

TEST(ObstacleErrors, NameFileLineAndKey) {
  EXPECT_EQ(errors_of("spheres = [[1, 2]]"),
            "rocks.toml:6: obstacle.spheres: number 1 of the list: must have 3 numbers in 2 dimensions, but "
            "has 2\n");
  EXPECT_NE(errors_of("spheres = [[1, 2, 0]]").find("the radius must be above 0"), std::string::npos);
  EXPECT_NE(errors_of("spheres = [1, 2, 3]").find("must be a list of lists of numbers"), std::string::npos);
  EXPECT_NE(errors_of("spheres = [[1, \"a\", 3]]").find("must be a list of numbers"), std::string::npos);
  EXPECT_NE(errors_of("spheres = [[1, 2, nan]]").find("nan"), std::string::npos);
  EXPECT_NE(errors_of("boxes = [[5, 5, 5, 9]]").find("the lower corner must be below"), std::string::npos);
  EXPECT_NE(errors_of("planes = [[0, 0, 0, 0]]").find("the normal must have a direction"), std::string::npos);
  EXPECT_NE(errors_of("sphere = []").find("did you mean \"spheres\"?"), std::string::npos);
  EXPECT_EQ(errors_of(""), "");
}

TEST(ObstacleErrors, WrappedSpacesTakeNoPlanesAndNothingAsLargeAsTheyAre) {
  const std::string wrap = "boundary = \"wrap\"";
  EXPECT_NE(errors_of("planes = [[0, 0, 0, 1]]", wrap).find("build a wall of boxes"), std::string::npos);
  EXPECT_NE(
      errors_of("spheres = [[0, 0, 40]]", wrap).find("smaller than the wrapped space, which is 80 long"),
      std::string::npos);
  EXPECT_EQ(errors_of("spheres = [[0, 0, 39]]", wrap), "");
  EXPECT_EQ(errors_of("spheres = [[0, 0, 40]]"), "");
}

TEST(RandomObstacles, ThatDoNotFitAreToldApart) {
  EXPECT_NE(
      errors_of("random = { count = 500, radius = [5, 6] }").find(" of 500 found no room in 1000 tries"),
      std::string::npos);
  EXPECT_NE(errors_of("random = { count = 1, radius = [50, 60] }").find("sphere 1 of 1 found no room"),
            std::string::npos);
  EXPECT_NE(errors_of("random = { count = 1, radius = [0, 6] }").find("must be above 0"), std::string::npos);
}

// Distances by the nearest image, in double.
double gap_between(const Obstacle& a, const Obstacle& b, const Extent& extent, bool wraps) {
  double squared = 0;
  for (std::size_t axis = 0; axis < extent.min.size(); ++axis) {
    const double size = extent.max[axis] - extent.min[axis];
    double o = std::abs(double{a.at[axis]} - double{b.at[axis]});
    if (wraps) o = std::min(o, size - o);
    squared += o * o;
  }
  return std::sqrt(squared) - double{a.radius} - double{b.radius};
}

RC_GTEST_PROP(RandomObstacles, KeepApartAndStayInTheSpace, ()) {
  ScenarioDef scenario;
  scenario.space.dimensions = *rc::gen::inRange(2, 4);
  const auto axes = static_cast<std::size_t>(scenario.space.dimensions);
  scenario.space.min = Coordinates(axes, -60.0);
  scenario.space.max = Coordinates(axes, 90.0);
  scenario.space.max[0] = *rc::gen::inRange(20, 200);
  const bool wraps = *rc::gen::arbitrary<bool>();
  scenario.space.boundary.kind = wraps ? BoundaryKind::wrap : BoundaryKind::open;
  scenario.seed = *rc::gen::inRange(0, 1000);
  scenario.obstacles.resize(1);
  const double apart = *rc::gen::inRange(0, 5);
  scenario.obstacles[0].random =
      RandomObstacles{*rc::gen::inRange(0, 60), 1, *rc::gen::inRange(1, 4) * 1.0, apart};
  const auto result = obstacles_of(scenario);
  RC_PRE(static_cast<bool>(result));
  RC_ASSERT(result->size() == static_cast<std::size_t>(scenario.obstacles[0].random->count));
  for (std::size_t i = 0; i < result->size(); ++i) {
    const Obstacle& one = (*result)[i];
    RC_ASSERT(one.radius >= 1 && one.radius <= scenario.obstacles[0].random->max_radius);
    const double rim = wraps ? 0 : double{one.radius} * (1 - 1e-5);
    for (std::size_t axis = 0; axis < axes; ++axis) {
      RC_ASSERT(one.at[axis] >= scenario.space.min[axis] + rim &&
                one.at[axis] <= scenario.space.max[axis] - rim);
    }
    for (std::size_t j = 0; j < i; ++j)
      RC_ASSERT(gap_between(one, (*result)[j], extent_of(scenario), wraps) >= apart - 1e-9);
  }
}

TEST(RandomObstacles, AreAFunctionOfTheSeed) {
  ScenarioDef scenario = read(text);
  const auto before = take(obstacles_of(scenario));
  EXPECT_EQ(take(obstacles_of(scenario)), before);
  scenario.seed += 1;
  EXPECT_NE(take(obstacles_of(scenario)), before);
}

RC_GTEST_PROP(ObstacleDefinitions, MakeTheVeryObstaclesTheyWereMadeOf, ()) {
  std::vector<Obstacle> obstacles(*rc::gen::inRange<std::size_t>(0, 8));
  const auto some = [] { return static_cast<float>(*rc::gen::inRange(-100000, 100000)) / 777.0f; };
  ScenarioDef scenario;
  scenario.space.dimensions = 3;
  scenario.space.boundary.kind = BoundaryKind::open;
  for (Obstacle& obstacle : obstacles) {
    obstacle.kind = *rc::gen::element(ObstacleKind::sphere, ObstacleKind::box, ObstacleKind::plane);
    obstacle.at = {some(), some(), some()};
    if (obstacle.kind == ObstacleKind::sphere) obstacle.radius = std::abs(some()) + 0.1f;
    if (obstacle.kind == ObstacleKind::box)
      obstacle.half = {std::abs(some()) + 0.1f, std::abs(some()) + 0.1f, std::abs(some()) + 0.1f};
    if (obstacle.kind == ObstacleKind::plane)
      obstacle.normal = unit(Vec<3>{{some(), some(), some() + 0.01f}}).at;
    RC_PRE(obstacle.kind != ObstacleKind::plane || obstacle.normal != Point{});
  }
  scenario.obstacles = definitions_of(obstacles, 3);
  RC_ASSERT(take(obstacles_of(scenario)) == obstacles);
  scenario.flocks.front().count = 1;
  RC_ASSERT(take(obstacles_of(take(parse_scenario(to_toml(scenario), "again")))) == obstacles);
}

}  // namespace
}  // namespace sturnus::test
