// A living world in lanes against the plain loop, bit for bit: hunters, obstacles of every shape and food in
// random worlds, crowded and nearly empty, so that lanes are ruled out for every reason and for none.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>

#include "isas.h"
#include "support.h"

namespace sturnus::test {
namespace {

/// Picks what a world is made of.
class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  double number(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_() >> 8) / double{1 << 24});
  }
  bool coin() { return random_() % 2 == 0; }
  template <class T>
  T one_of(std::initializer_list<T> values) {
    return *(values.begin() + random_() % values.size());
  }

 private:
  std::mt19937 random_;
};

/// Lengths from a twentieth of the world to half of it, mostly short ones.
double length_in(Dice& dice, double world) {
  return world * dice.one_of({0.05, 0.1, 0.2, dice.number(0.02, 0.5)});
}

Coordinates place_in(Dice& dice, int dimensions, double world) {
  Coordinates at;
  for (int axis = 0; axis < dimensions; ++axis) at.push_back(dice.number(0, world));
  return at;
}

ObstacleDef some_obstacles(Dice& dice, int dimensions, double world, bool wraps) {
  ObstacleDef out;
  // Now and then so many that boids ask for them one by one.
  const bool are_many = dice.one_of({false, false, true});
  const int count = are_many ? 50 << static_cast<int>(dice.number(0, 6)) : 6;
  for (int i = 0; i < count; ++i) {
    out.spheres.push_back(place_in(dice, dimensions, world));
    out.spheres.back().push_back(dice.number(0.002, are_many ? 0.004 : 0.06) * world);
  }
  if (dice.coin()) {
    Coordinates box = place_in(dice, dimensions, 0.8 * world);
    for (int axis = 0; axis < dimensions; ++axis)
      box.push_back(box[static_cast<std::size_t>(axis)] + dice.number(0.01, 0.2) * world);
    out.boxes.push_back(box);
  }
  if (!wraps && dice.coin()) {
    Coordinates plane(static_cast<std::size_t>(dimensions), 0.1 * world);
    for (int axis = 0; axis < dimensions; ++axis) plane.push_back(axis == 0 ? 1 : dice.number(-0.2, 0.2));
    out.planes.push_back(plane);
  }
  return out;
}

FlockDef prey(Dice& dice, double world) {
  FlockDef flock;
  flock.name = "prey";
  flock.count = static_cast<std::int64_t>(dice.one_of({3.0, 40.0, 300.0, 900.0}));
  flock.max_speed = world * dice.one_of({0.002, 0.02, 0.1});
  flock.min_speed = dice.coin() ? 0 : 0.5 * flock.max_speed;
  flock.max_acceleration = dice.coin() ? infinity : 0.1 * flock.max_speed;
  flock.body_radius = world * dice.one_of({0.001, 0.005, 0.02});
  flock.separation = {{.weight = 0.5, .radius = length_in(dice, world)}};
  flock.alignment = {{.weight = 0.1, .radius = length_in(dice, world)}};
  flock.cohesion = {{.weight = 0.01, .radius = length_in(dice, world)}};
  const auto form = [&] {
    return dice.one_of({SteeringForm::heading, SteeringForm::seek, SteeringForm::linear});
  };
  flock.flee = {{.from = {"hunters"}, .radius = length_in(dice, world), .form = form()}};
  flock.feed = Feed{.on = "food", .radius = length_in(dice, world), .form = form(), .births = dice.coin()};
  flock.avoid_obstacles =
      AvoidObstacles{.look_ahead = length_in(dice, world),
                     .clearance = 0.01 * world,
                     .form = dice.one_of({ObstacleForm::sweep, ObstacleForm::sweep, ObstacleForm::heading}),
                     .radius = length_in(dice, world)};
  return flock;
}

FlockDef hunters(Dice& dice, double world) {
  FlockDef flock = prey(dice, world);
  flock.name = "hunters";
  flock.count = dice.coin() ? 2 : 30;
  flock.flee = {};
  flock.feed = {};
  if (dice.coin()) {
    flock.separation = {};
    flock.alignment = {};
    flock.cohesion = {};
  }
  flock.hunt = Hunt{.prey = {"prey"}, .sight = length_in(dice, world)};
  flock.hunt->choose = dice.one_of({HuntChoice::average, HuntChoice::nearest});
  flock.hunt->aim = dice.one_of(
      {HuntAim::heading, HuntAim::seek, HuntAim::constant, HuntAim::distance, HuntAim::intercept});
  flock.hunt->confusion = dice.one_of({0.0, 0.05});
  flock.hunger = Hunger{.full_for = 2, .starves_after = dice.one_of({3.0, infinity})};
  if (dice.coin()) {
    flock.jump = Jump{.speed = 2 * flock.max_speed, .duration = 3, .cooldown = 2};
    flock.jump->distance = length_in(dice, world);
    flock.jump->field_of_view = 200;
  }
  return flock;
}

std::vector<TargetDef> some_targets(Dice& dice, int dimensions, double world) {
  std::vector<TargetDef> out;
  for (const TargetKind kind : {TargetKind::attract, TargetKind::repel}) {
    TargetDef target;
    target.name = kind == TargetKind::attract ? "attract" : "repel";
    target.kind = kind;
    target.form = dice.one_of({SteeringForm::heading, SteeringForm::seek, SteeringForm::linear,
                               SteeringForm::arrive, SteeringForm::orbit});
    target.at = place_in(dice, dimensions, world);
    target.radius = dice.one_of({infinity, length_in(dice, world)});
    target.slowing = 0.1 * world;
    target.motion = dice.one_of({TargetMotion::still, TargetMotion::circle});
    target.circle = 0.2 * world;
    target.period = 40;
    out.push_back(target);
  }
  return out;
}

void colour_in(Dice& dice, FlockDef& flock) {
  flock.colour = {
      .start = "random", .averaging = dice.number(0, 0.2), .noise = dice.number(0, 0.1), .of = {}};
}

ScenarioDef living_world(unsigned seed) {
  Dice dice(seed);
  const int dimensions = dice.coin() ? 2 : 3;
  const double world = dice.one_of({1.0, 100.0, 5000.0});
  ScenarioDef scenario = bare(dimensions);
  scenario.seed = seed;
  scenario.space.min = Coordinates(static_cast<std::size_t>(dimensions), 0.0);
  scenario.space.max = Coordinates(static_cast<std::size_t>(dimensions), world);
  scenario.space.boundary.kind =
      dice.one_of({BoundaryKind::wrap, BoundaryKind::wrap, BoundaryKind::open, BoundaryKind::bounce});
  scenario.index.kind = dice.one_of({IndexKind::grid, IndexKind::grid, IndexKind::tree});
  const bool wraps = scenario.space.boundary.kind == BoundaryKind::wrap;
  scenario.obstacles = {some_obstacles(dice, dimensions, world, wraps)};
  scenario.flocks = {prey(dice, world), hunters(dice, world)};
  if (dice.coin()) scenario.targets = some_targets(dice, dimensions, world);
  if (dice.coin()) {
    for (FlockDef& flock : scenario.flocks) colour_in(dice, flock);
  }
  scenario.space.solid = dice.coin();
  if (dice.coin()) std::swap(scenario.flocks[0], scenario.flocks[1]);
  FoodDef food;
  food.count = dice.coin() ? 5 : 200;
  food.body_radius = 0.01 * world;
  scenario.food = {food};
  return scenario;
}

/// Some steps of the plain loop beside all instruction sets of this machine.
void run_side_by_side(const ScenarioDef& scenario) {
  const IsaGuard guard;
  SimulationOptions options;
  options.threads = 1;
  auto created = Simulation::create(scenario, options);
  if (!created) return;  // obstacles may leave no room for a flock
  Simulation plain = take(std::move(created));
  std::vector<Simulation> wide;
  for (std::size_t i = 0; i < std::size(wide_isas); ++i) wide.push_back(start(scenario, 2));
  for (int step = 0; step < 6; ++step) {
    use_isa(Isa::plain);
    plain.step();
    for (std::size_t i = 0; i < wide.size(); ++i) {
      if (!use_isa(wide_isas[i].isa)) continue;
      wide[i].poison_scratch();
      wide[i].step();
      RC_ASSERT(wide[i].hash() == plain.hash());
    }
  }
}

RC_GTEST_PROP(LivingInLanes, StepsLikeThePlainLoop, ()) {
  run_side_by_side(living_world(*rc::gen::arbitrary<unsigned>()));
}

// So that the worlds above are about what they are said to be about.
TEST(LivingInLanes, MeetsEverythingThatLives) {
  std::size_t jumps = 0, starved = 0, eaten = 0, born = 0, solid = 0, crowded = 0, targets = 0, colours = 0;
  int worlds = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const ScenarioDef scenario = living_world(seed);
    auto created = Simulation::create(scenario);
    if (!created) continue;
    ++worlds;
    Simulation world = take(std::move(created));
    world.run(6);
    const State& state = world.view().state();
    jumps +=
        std::any_of(state.life.jump.begin(), state.life.jump.end(), [](double left) { return left > 0; });
    starved += world.report().starved > 0;
    eaten += world.report().eaten > 0;
    born += world.report().born > 0;
    solid += scenario.space.solid;
    crowded += state.obstacles.size() > 500;
    targets += !scenario.targets.empty();
    colours += !state.colour[0].empty();
  }
  EXPECT_GT(worlds, 60);
  for (const std::size_t happened : {jumps, starved, eaten, born, solid, crowded, targets, colours})
    EXPECT_GT(happened, 5u);
}

}  // namespace
}  // namespace sturnus::test
