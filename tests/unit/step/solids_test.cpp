// Solid obstacles: nobody ends a step inside one, whatever the speed, the world and the obstacles; and what a
// boid does where it is stopped.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "support.h"

namespace sturnus::test {
namespace {

/// How deep a boid is inside an obstacle, as a share of its size, and inside the edge of a world that nobody
/// leaves: from the scenario's numbers, in double, by the shortest way on every axis.
class Referee {
 public:
  explicit Referee(const ScenarioDef& scenario)
      : extent_(extent_of(scenario)),
        wraps_(scenario.space.boundary.kind == BoundaryKind::wrap),
        bounces_(scenario.space.boundary.kind == BoundaryKind::bounce),
        body_(scenario.flocks.front().body_radius) {}

  double depth(const Point& at, const Obstacle& obstacle) const {
    double squared = 0, beyond = 0, past = -infinity, least = infinity;
    for (std::size_t axis = 0; axis < extent_.min.size(); ++axis) {
      const double size = static_cast<float>(extent_.max[axis]) - static_cast<float>(extent_.min[axis]);
      const double o = double{at[axis]} - double{obstacle.at[axis]};
      const double way = wraps_ ? std::min(std::abs(o), size - std::abs(o)) : std::abs(o);
      squared += way * way;
      beyond += o * double{obstacle.normal[axis]};
      past = std::max(past, way - double{obstacle.half[axis]} - body_);
      least = std::min(least, double{obstacle.half[axis]} + body_);
    }
    if (obstacle.kind == ObstacleKind::plane) return (body_ - beyond) / (extent_.max[0] - extent_.min[0]);
    if (obstacle.kind == ObstacleKind::box) return -past / least;
    const double radius = double{obstacle.radius} + body_;
    return (radius - std::sqrt(squared)) / radius;
  }

  bool has_left(const Point& at) const {
    for (std::size_t axis = 0; axis < extent_.min.size(); ++axis) {
      if (at[axis] < static_cast<float>(extent_.min[axis]) ||
          at[axis] > static_cast<float>(extent_.max[axis]))
        return true;
    }
    return false;
  }

  /// Boids that are inside of something or outside of the world.
  std::size_t escapes(const View& view) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < view.size(); ++i) {
      bool escaped = (bounces_ || wraps_) && has_left(view.position(i));
      for (const Obstacle& obstacle : view.state().obstacles)
        escaped = escaped || depth(view.position(i), obstacle) > 1e-5;
      count += escaped ? 1 : 0;
    }
    return count;
  }

 private:
  Extent extent_;
  bool wraps_, bounces_;
  double body_;
};

/// Boids that dash about at random among overlapping obstacles of a space of 100 on each side.
ScenarioDef turmoil(int dimensions, BoundaryKind boundary, double speed) {
  ScenarioDef scenario;
  const auto axes = static_cast<std::size_t>(dimensions);
  scenario.space = {dimensions, Coordinates(axes, -50.0), Coordinates(axes, 50.0),
                    {},         {boundary, {10}, 0.5},    true};
  FlockDef& flock = scenario.flocks.front();
  flock.count = 500;
  flock.start.min_speed = flock.start.max_speed = speed;
  flock.max_speed = speed;
  flock.min_speed = speed / 10;
  flock.max_acceleration = speed;
  flock.noise = Noise{.acceleration = speed / 2, .turn = 40};
  flock.body_radius = 0.4;
  return scenario;
}

void add_obstacles(ScenarioDef& scenario) {
  ObstacleDef obstacles;
  const bool flat = scenario.space.dimensions == 2;
  // Three that overlap, one over the corner of the space, one small, a box into a sphere.
  obstacles.spheres =
      flat ? std::vector<Coordinates>{{0, 0, 8}, {10, 2, 7}, {4, 9, 6}, {48, 47, 9}, {-20, -20, 0.5}}
           : std::vector<Coordinates>{
                 {0, 0, 0, 8}, {10, 2, 3, 7}, {4, 9, 0, 6}, {48, 47, 46, 9}, {-20, -20, 5, 0.5}};
  obstacles.boxes = flat
                        ? std::vector<Coordinates>{{-35, 10, -20, 12}, {-30, 5, -28, 30}, {12, -2, 30, 0}}
                        : std::vector<Coordinates>{
                              {-35, 10, -10, -20, 12, 20}, {-30, 5, -40, -28, 30, 8}, {12, -2, -5, 30, 0, 9}};
  if (scenario.space.boundary.kind != BoundaryKind::wrap)
    obstacles.planes =
        flat ? std::vector<Coordinates>{{0, -40, 1, 3}} : std::vector<Coordinates>{{0, -40, 0, 1, 3, -1}};
  obstacles.random = RandomObstacles{20, 0.5, 3, 0};
  scenario.obstacles.push_back(obstacles);
}

std::size_t escapes_in(const ScenarioDef& scenario, int steps) {
  Simulation simulation = start(scenario, 2);
  const Referee referee(scenario);
  std::size_t escapes = referee.escapes(simulation.view());
  for (int step = 0; step < steps; ++step) {
    simulation.step();
    escapes += referee.escapes(simulation.view());
  }
  return escapes;
}

struct Turmoil {
  int dimensions;
  BoundaryKind boundary;
  double speed;
};
void PrintTo(const Turmoil& one, std::ostream* out) {
  *out << one.dimensions << "D, boundary " << static_cast<int>(one.boundary) << ", speed " << one.speed;
}

class Solids : public testing::TestWithParam<Turmoil> {};
class FullSolids : public Solids {};

std::size_t escapes_of(const Turmoil& one, int steps) {
  ScenarioDef scenario = turmoil(one.dimensions, one.boundary, one.speed);
  add_obstacles(scenario);
  return escapes_in(scenario, steps);
}

TEST_P(Solids, NobodyEndsAStepInside) {
  EXPECT_EQ(escapes_of(GetParam(), 170), 0u);
}
TEST_P(FullSolids, NobodyEndsAStepInside) {
  EXPECT_EQ(escapes_of(GetParam(), 2000), 0u);
}

const auto turmoils =
    testing::Values(Turmoil{2, BoundaryKind::wrap, 0.5}, Turmoil{2, BoundaryKind::wrap, 30},
                    Turmoil{2, BoundaryKind::wrap, 1000}, Turmoil{2, BoundaryKind::bounce, 3},
                    Turmoil{2, BoundaryKind::bounce, 200}, Turmoil{2, BoundaryKind::turn, 3},
                    Turmoil{2, BoundaryKind::open, 100}, Turmoil{3, BoundaryKind::wrap, 3},
                    Turmoil{3, BoundaryKind::wrap, 300}, Turmoil{3, BoundaryKind::bounce, 0.5},
                    Turmoil{3, BoundaryKind::bounce, 90}, Turmoil{3, BoundaryKind::turn, 20});
INSTANTIATE_TEST_SUITE_P(In, Solids, turmoils);
INSTANTIATE_TEST_SUITE_P(Full, FullSolids, turmoils);

RC_GTEST_PROP(Solids, NobodyEndsAStepInsideOfAnything, ()) {
  const auto boundary = *rc::gen::element(BoundaryKind::wrap, BoundaryKind::bounce, BoundaryKind::turn);
  ScenarioDef scenario =
      turmoil(*rc::gen::inRange(2, 4), boundary, *rc::gen::element(0.1, 2.0, 40.0, 2000.0));
  scenario.seed = *rc::gen::inRange(0, 100000);
  scenario.flocks.front().count = 60;
  scenario.flocks.front().body_radius = *rc::gen::element(0.0, 0.4, 2.0);
  scenario.time.integrator = *rc::gen::element(Integrator::explicit_euler, Integrator::semi_implicit_euler);
  scenario.obstacles.resize(1);
  // Their surfaces may overlap by any amount.
  std::vector<Coordinates>& spheres = scenario.obstacles[0].spheres;
  for (int n = *rc::gen::inRange(0, 40); n > 0; --n) {
    Coordinates sphere;
    for (std::int64_t axis = 0; axis < scenario.space.dimensions; ++axis)
      sphere.push_back(*rc::gen::inRange(-500, 500) / 10.0);
    sphere.push_back(*rc::gen::inRange(1, 80) / 10.0);
    spheres.push_back(sphere);
  }
  RC_ASSERT(escapes_in(scenario, 30) == 0);
}

// ---- births, food and boids that are added ----

/// Only what obstacles do.
ScenarioDef quiet(const std::vector<Coordinates>& spheres) {
  ScenarioDef scenario = bare();
  scenario.space.solid = true;
  scenario.flocks.front().body_radius = 1;
  scenario.obstacles = {{spheres, {}, {}, {}}};
  return scenario;
}

FoodDef pieces(std::int64_t count) {
  FoodDef food;
  food.count = count;
  return food;
}

/// Turmoil in which boids eat and are born, more of them in every step until they are many.
ScenarioDef fertile(const Turmoil& one) {
  ScenarioDef scenario = turmoil(one.dimensions, one.boundary, one.speed);
  add_obstacles(scenario);
  scenario.flocks.front().feed = Feed{.on = "food", .births = 2, .population_cap = 4000};
  FoodDef food;
  food.body_radius = 3;  // so that the newborn stand well beside
  food.random = {.every = 1, .count = 200, .most = 400};
  scenario.food = {food};
  return scenario;
}

TEST_P(Solids, NobodyIsBornInside) {
  const ScenarioDef scenario = fertile(GetParam());
  Simulation simulation = start(scenario, 2);
  const Referee referee(scenario);
  for (int step = 0; step < 30; ++step) {
    simulation.step();
    ASSERT_EQ(referee.escapes(simulation.view()), 0u) << "step " << step;
  }
  EXPECT_GT(simulation.report().born, 200u);
}

TEST_P(Solids, NobodyIsAddedOrPutInside) {
  const Turmoil& one = GetParam();
  ScenarioDef scenario = turmoil(one.dimensions, one.boundary, one.speed);
  add_obstacles(scenario);
  Simulation simulation = start(scenario);
  const Referee referee(scenario);
  // In the thick of spheres that overlap, over the edge, in a box, behind the plane.
  for (const Coordinates& place : std::vector<Coordinates>{
           {4, 4, 2}, {0, 0, 0}, {49, 49, 49}, {-29, 11, 3}, {-49, 49, -49}, {0, -45, 0}}) {
    const Coordinates at(place.begin(), place.begin() + one.dimensions);
    const Coordinates velocity(at.size(), 0.0);
    must(simulation.push(AddBoids{"boids", 20, at, 0}));
    must(simulation.push(AddBoids{"boids", 20, at, 5}));
    must(simulation.push(MoveBoid{7, at, velocity}));
    EXPECT_EQ(referee.escapes(simulation.view()), 0u) << at[0] << ", " << at[1];
  }
  EXPECT_EQ(simulation.view().size(), 500u + 6 * 40);
}

// Where a body of 1 that feeds on it can stand; the pieces' own is smaller.
TEST_P(Solids, NoFoodFallsWhereNobodyReachesIt) {
  ScenarioDef scenario = fertile(GetParam());
  scenario.flocks.front().body_radius = 1;
  scenario.flocks.front().feed->births = 0;
  scenario.food[0].count = 100;
  scenario.food[0].body_radius = 0.2;
  const Coordinates middle(scenario.space.min.size(), 2.0);
  scenario.run.events = {{2, AddFood{"food", 30, middle, 4}}};
  Simulation simulation = start(scenario);
  const Referee referee(scenario);
  std::size_t fallen = 0;
  for (int step = 0; step < 20; ++step) {
    const Food& food = simulation.view().state().food;
    for (std::size_t i = 0; i < food.size(); ++i) {
      Point at{};
      for (std::size_t axis = 0; axis < middle.size(); ++axis) at[axis] = food.position[axis][i];
      for (const Obstacle& obstacle : simulation.view().state().obstacles)
        ASSERT_LT(referee.depth(at, obstacle), 1e-5) << "step " << step;
    }
    fallen += food.size();
    simulation.step();
  }
  EXPECT_GT(fallen, 2000u);
}

TEST(Solid, IsNoPlaceForFoodWhereNothingIsFree) {
  ScenarioDef scenario = quiet({{0, 0, 5000}});
  scenario.space.boundary.kind = BoundaryKind::bounce;
  scenario.food = {pieces(10)};
  scenario.food[0].random = {.every = 1, .count = 3};
  Simulation simulation = world_of(scenario, {});
  simulation.run(5);
  must(simulation.push(AddFood{"food", 5, {1, 1}, 20}));
  EXPECT_EQ(simulation.view().state().food.size(), 0u);
}

// ---- what a stop looks like ----

TEST(Solid, StopsJustBeforeTheSurfaceAndDropsTheInwardVelocity) {
  Simulation simulation = world_of(quiet({{50, 0, 9}}), {{{0, 0}, {100, 0}}, {{0, 6}, {100, 0}}});
  simulation.step();
  EXPECT_NEAR(position_of(simulation, 0)[0], 40 - 10 * 1e-4, 1e-4);
  EXPECT_NEAR(velocity_of(simulation, 0)[0], 0, 1e-4);
  // Met at (42, 6), where the normal is (-0.8, 0.6): v - (v n) n.
  EXPECT_NEAR(position_of(simulation, 1)[0], 42 - 8e-4, 1e-4);
  EXPECT_NEAR(velocity_of(simulation, 1)[0], 36, 1e-3);
  EXPECT_NEAR(velocity_of(simulation, 1)[1], 48, 1e-3);
}

TEST(Solid, LeavesAloneWhoMissesAndWhoGoesAway) {
  Simulation simulation = world_of(quiet({{50, 0, 9}}), {{{0, 10.01f}, {100, 0}}, {{39, 0}, {-5, 0}}});
  simulation.step();
  EXPECT_EQ(position_of(simulation, 0), (Point{100, 10.01f, 0}));
  EXPECT_EQ(position_of(simulation, 1), (Point{34, 0, 0}));
}

TEST(Solid, BringsWhoStartsInsideToTheNearestSurface) {
  Simulation simulation = world_of(quiet({{50, 0, 9}}), {{{52, 0}, {-3, 1}}});
  simulation.step();
  EXPECT_NEAR(position_of(simulation, 0)[0], 60.001, 1e-4);
  EXPECT_NEAR(position_of(simulation, 0)[1], 0, 1e-6);
  EXPECT_EQ(velocity_of(simulation, 0), (Point{0, 1, 0}));
}

TEST(Solid, PutsWhoIsAddedInsideToTheNearestSurface) {
  Simulation simulation = world_of(quiet({{50, 0, 9}}), {{{0, 0}, {0, 0}}});
  must(simulation.push(AddBoids{"boids", 1, {52, 0}, 0}));
  EXPECT_NEAR(position_of(simulation, 1)[0], 60.001, 1e-4);
  must(simulation.push(MoveBoid{0, {50, -3}, {1, 0}}));
  EXPECT_NEAR(position_of(simulation, 0)[1], -10.001, 1e-4);
}

TEST(Solid, LetsNobodyComeWhereThereIsNoPlaceAtAll) {
  ScenarioDef scenario = quiet({});
  scenario.space.boundary.kind = BoundaryKind::bounce;
  Simulation simulation = world_of(scenario, {{{0, 0}, {0, 0}}});
  must(simulation.push(PlaceObstacle{{0, 0}, 5000}));
  must(simulation.push(AddBoids{"boids", 3, {1, 2}, 1}));
  EXPECT_EQ(simulation.view().size(), 1u);
  EXPECT_EQ(simulation.report().commands_in_vain, 1u);
  must(simulation.push(MoveBoid{0, {10, 10}, {0, 0}}));
  EXPECT_EQ(position_of(simulation, 0), (Point{0, 0, 0})) << "he stays where he was";
  EXPECT_EQ(simulation.report().commands_in_vain, 2u);
}

TEST(Solid, LetsTheNewbornComeFromTheirParentsSideOfAWall) {
  // The food lies before a thin wall, the way beside it often leads through.
  ScenarioDef scenario = quiet({});
  scenario.obstacles[0].boxes = {{-100, 1.5, 100, 1.6}};
  scenario.flocks.front().feed = Feed{.on = "food", .weight = 0, .births = 40, .population_cap = 100};
  scenario.food = {pieces(0)};
  Simulation simulation = world_of(scenario, {{{0, 0}, {0, 0}}});
  must(simulation.push(AddFood{"food", 1, {0, 0.4}, 0}));
  simulation.step();
  ASSERT_EQ(simulation.view().size(), 41u);
  for (std::size_t i = 0; i < 41; ++i) EXPECT_LT(simulation.view().position(i)[1], 0.5 + 1e-5);
}

TEST(Births, StayInAWorldThatBouncesEvenWhereNothingIsSolid) {
  ScenarioDef scenario = bare();
  scenario.space.boundary.kind = BoundaryKind::bounce;
  scenario.flocks.front().feed = Feed{.on = "food", .weight = 0, .births = 40, .population_cap = 100};
  scenario.food = {pieces(0)};
  Simulation simulation = world_of(scenario, {{{1000, 0}, {0, 0}}});
  must(simulation.push(AddFood{"food", 1, {1000, 0}, 0}));
  simulation.step();
  ASSERT_EQ(simulation.view().size(), 41u);
  EXPECT_EQ(Referee(scenario).escapes(simulation.view()), 0u);
}

TEST(Solid, IsAskedFor) {
  ScenarioDef scenario = quiet({{50, 0, 9}});
  scenario.space.solid = false;
  Simulation simulation = world_of(scenario, {{{0, 0}, {50, 0}}});
  simulation.step();
  EXPECT_EQ(position_of(simulation, 0), (Point{50, 0, 0}));
}

TEST(Solid, MeetsImagesAcrossTheSeam) {
  ScenarioDef scenario = quiet({{-950, 0, 9}});
  scenario.space.boundary.kind = BoundaryKind::wrap;
  Simulation simulation = world_of(scenario, {{{900, 0}, {400, 0}}});
  simulation.step();
  EXPECT_NEAR(position_of(simulation, 0)[0], -960, 0.01);
}

TEST(Solid, ChangesNoBitFarFromObstacles) {
  ScenarioDef scenario = turmoil(2, BoundaryKind::wrap, 2);
  scenario.obstacles = {{{{10, 10, 1}}, {}, {}, {}}};
  ScenarioDef loose = scenario;
  loose.space.solid = false;
  const std::vector<Placed> boids = {{{-30, -30}, {1, 0}}, {{-20, -20}, {0, 1}}};
  Simulation one = world_of(scenario, boids), other = world_of(loose, boids);
  for (int step = 0; step < 5; ++step) {
    one.step();
    other.step();
    EXPECT_EQ(one.hash(), other.hash());
  }
}

// ---- starts ----

TEST(Starts, AreOutsideOfObstacles) {
  ScenarioDef scenario = turmoil(2, BoundaryKind::wrap, 1);
  add_obstacles(scenario);
  scenario.space.solid = false;
  scenario.flocks.front().count = 3000;
  Simulation simulation = start(scenario);
  EXPECT_EQ(Referee(scenario).escapes(simulation.view()), 0u);
  must(simulation.push(AddBoids{"boids", 200, {4, 4}, 20}));
  EXPECT_EQ(Referee(scenario).escapes(simulation.view()), 0u);
}

TEST(Starts, ThatAreCoveredByObstaclesAreRefused) {
  ScenarioDef scenario = turmoil(2, BoundaryKind::open, 1);
  scenario.obstacles = {{{{0, 0, 90}}, {}, {}, {}}};
  const auto refused = Simulation::create(scenario);
  ASSERT_FALSE(refused);
  EXPECT_NE(
      refused.error().find("flock.boids.start: 500 of 500 boids found no place outside of the obstacles"),
      std::string::npos)
      << refused.error();
}

}  // namespace
}  // namespace sturnus::test
