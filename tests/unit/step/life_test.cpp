// Eating, starving, jumping, births and deaths: when they happen, to whom, and what they leave behind.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include <sturnus/files.h>

#include "isas.h"
#include "support.h"

namespace sturnus::test {
namespace {

/// Hunters are flock 0, prey flock 1; nobody is steered.
ScenarioDef still_world(double dt = 1) {
  ScenarioDef scenario = bare();
  scenario.time.dt = dt;
  scenario.flocks.push_back(scenario.flocks.front());
  scenario.flocks[0].name = "hunters";
  scenario.flocks[1].name = "prey";
  scenario.flocks[0].max_speed = 10;
  scenario.flocks[0].body_radius = 4;
  scenario.flocks[1].body_radius = 1;
  scenario.flocks[0].hunt = Hunt{.prey = {"prey"}, .sight = 100, .weight = 0};
  return scenario;
}

std::set<std::uint64_t> ids_of(const Simulation& world) {
  return {world.view().state().id.begin(), world.view().state().id.end()};
}
std::size_t members(const Simulation& world, int flock) {
  const auto& flocks = world.view().state().flock;
  return static_cast<std::size_t>(std::count(flocks.begin(), flocks.end(), flock));
}
double clock_of(const Simulation& world, const std::vector<double> Life::*clock, std::uint64_t id) {
  return (world.view().state().life.*clock)[world.view().slot(id).value()];
}

TEST(Touch, ReachesFromBodyToBodyAndNoFarther) {
  for (const auto& [x, eaten] :
       std::vector<std::pair<float, bool>>{{4.99f, true}, {5, true}, {5.01f, false}}) {
    Simulation world = world_of(still_world(), {{{0, 0}, {0, 0}, 0}, {{x, 0}, {0, 0}, 1}});
    world.step();
    EXPECT_EQ(world.view().size(), eaten ? 1u : 2u) << x;
  }
}

TEST(Touch, ReachesOverTheSeam) {
  ScenarioDef scenario = still_world();
  scenario.space.boundary.kind = BoundaryKind::wrap;
  Simulation world = world_of(scenario, {{{998, 0}, {0, 0}, 0}, {{-999, 0}, {0, 0}, 1}});
  world.step();
  EXPECT_EQ(ids_of(world), (std::set<std::uint64_t>{0}));
}

TEST(Touch, CountsWhereTheyStandAfterTheStep) {
  Simulation world = world_of(still_world(), {{{0, 0}, {0, 0}, 0}, {{8, 0}, {-4, 0}, 1}});
  world.step();
  EXPECT_EQ(world.view().size(), 1u);
}

TEST(Eating, OfTwoHuntersTheLowerIdEatsAndThePreyDiesOnce) {
  ScenarioDef scenario = still_world();
  scenario.flocks[0].hunger = Hunger{.full_for = 50};
  // The second hunter is nearer, but the first is asked first.
  Simulation world = world_of(scenario, {{{0, 4}, {0, 0}, 0}, {{0, -1}, {0, 0}, 0}, {{0, 0}, {0, 0}, 1}});
  world.step();
  EXPECT_EQ(ids_of(world), (std::set<std::uint64_t>{0, 1}));
  EXPECT_GT(clock_of(world, &Life::full, 0), 0);
  EXPECT_EQ(clock_of(world, &Life::full, 1), 0);
}

TEST(Eating, EachTakesTheNearestAndTheNextTakesWhatIsLeft) {
  ScenarioDef scenario = still_world();
  scenario.flocks[0].hunger = Hunger{.full_for = 50};
  Simulation world = world_of(scenario, {{{0, 0}, {0, 0}, 0},
                                         {{0, 1}, {0, 0}, 0},
                                         {{0, 2}, {0, 0}, 1},
                                         {{2, 0}, {0, 0}, 1},
                                         {{0, 3}, {0, 0}, 1}});
  world.step();
  // Ids 2 and 3 are equally near to hunter 0, which takes the lower; hunter 1 takes 4, which is nearer
  // than 3.
  EXPECT_EQ(ids_of(world), (std::set<std::uint64_t>{0, 1, 3}));
}

// In storage the ids run backwards, which must not matter.
TEST(Eating, GoesByIdsAndNotByTheOrderOfStorage) {
  ScenarioDef scenario = still_world();
  scenario.flocks[0].hunger = Hunger{.full_for = 50};
  State tied = state_of(2, {{{2, 0}, {0, 0}, 1}, {{0, 2}, {0, 0}, 1}, {{0, 0}, {0, 0}, 0}});
  tied.id = {2, 1, 0};
  Simulation one_of_two = world_from(scenario, tied);
  one_of_two.step();
  EXPECT_EQ(ids_of(one_of_two), (std::set<std::uint64_t>{0, 2}));
  State rivals = state_of(2, {{{1, 0}, {0, 0}, 0}, {{0, 0}, {0, 0}, 1}, {{-3, 0}, {0, 0}, 0}});
  rivals.id = {2, 1, 0};
  Simulation two_at_one = world_from(scenario, rivals);
  two_at_one.step();
  EXPECT_GT(clock_of(two_at_one, &Life::full, 0), 0);
  EXPECT_EQ(clock_of(two_at_one, &Life::full, 2), 0);
}

TEST(Eating, TheLastStepOfTheOthersIsStillKnown) {
  Simulation world =
      world_of(still_world(),
               {{{1, 0}, {0, 0}, 1}, {{0, 0}, {0, 0}, 0}, {{300, 0}, {2, 3}, 1}, {{400, 0}, {1, 0}, 1}});
  world.step();
  ASSERT_EQ(ids_of(world), (std::set<std::uint64_t>{1, 2, 3}));
  ASSERT_TRUE(world.view().has_previous());
  EXPECT_EQ(world.view().previous_position(world.view().slot(2).value()), (Point{300, 0, 0}));
  EXPECT_EQ(world.view().previous_velocity(world.view().slot(3).value()), (Point{1, 0, 0}));
}

TEST(Eating, AHunterThatIsEatenEatsNobody) {
  ScenarioDef scenario = still_world();
  scenario.flocks.push_back(scenario.flocks[1]);
  scenario.flocks[2].name = "krill";
  scenario.flocks[1].hunt = Hunt{.prey = {"krill"}, .sight = 100, .weight = 0};
  Simulation world = world_of(scenario, {{{0, 0}, {0, 0}, 0}, {{3, 0}, {0, 0}, 1}, {{4, 0}, {0, 0}, 2}});
  world.step();
  EXPECT_EQ(ids_of(world), (std::set<std::uint64_t>{0, 2}));
}

class Clocks : public testing::TestWithParam<double> {};

TEST_P(Clocks, FullForThatLongAndNotAStepLonger) {
  const double dt = GetParam();
  ScenarioDef scenario = still_world(dt);
  scenario.flocks[0].hunger = Hunger{.full_for = 6};
  std::vector<Placed> boids = {{{0, 0}, {0, 0}, 0}};
  for (int i = 0; i < 3; ++i) boids.push_back({{1, 0}, {0, 0}, 1});
  Simulation world = world_of(scenario, boids);
  std::vector<std::uint64_t> meals;
  for (std::size_t before = 4; world.step_number() < 2000; before = world.view().size()) {
    world.step();
    if (world.view().size() < before) meals.push_back(world.step_number());
  }
  const auto pause = static_cast<std::uint64_t>(std::ceil(6 / dt - 1e-9));
  EXPECT_EQ(meals, (std::vector<std::uint64_t>{1, 1 + pause, 1 + 2 * pause}));
}

TEST_P(Clocks, StarvesThatLongAfterTheLastMeal) {
  const double dt = GetParam();
  ScenarioDef scenario = still_world(dt);
  scenario.flocks[0].hunger = Hunger{.full_for = 1, .starves_after = 21};
  const auto steps = static_cast<std::uint64_t>(std::ceil(21 / dt - 1e-9));
  Simulation fed = world_of(scenario, {{{0, 0}, {0, 0}, 0}, {{1, 0}, {0, 0}, 1}});
  fed.step();
  fed.run(steps - 1);
  EXPECT_EQ(members(fed, 0), 1u);
  fed.step();
  EXPECT_EQ(members(fed, 0), 0u);
  Simulation unfed = world_of(scenario, {{{0, 0}, {0, 0}, 0}});
  unfed.run(steps - 1);
  EXPECT_EQ(members(unfed, 0), 1u);
  unfed.step();
  EXPECT_EQ(members(unfed, 0), 0u);
}

TEST_P(Clocks, AJumpIsFastStraightAndSlowsDownEvenlyThenItRests) {
  const double dt = GetParam();
  ScenarioDef scenario = still_world(dt);
  scenario.flocks[0].cruise = Cruise{.speed = 2, .weight = 0};
  scenario.flocks[0].noise = Noise{.acceleration = 1, .turn = 30};
  scenario.flocks[0].max_speed = 3;
  scenario.flocks[0].jump =
      Jump{.speed = 8, .duration = 6, .cooldown = 12, .distance = 300, .field_of_view = 360};
  scenario.flocks[1].body_radius = 0;
  scenario.flocks[0].body_radius = 0;
  Simulation world = world_of(scenario, {{{0, 0}, {0, 2}, 0}, {{-40, 0}, {0, 0}, 1}});
  const auto duration = static_cast<int>(std::ceil(6 / dt - 1e-9));
  const auto cooldown = static_cast<int>(std::ceil(12 / dt - 1e-9));
  for (int jump = 0; jump < 2; ++jump) {
    const Point heading = velocity_of(world, 0);
    for (int step = 0; step < duration; ++step) {
      world.step();
      const Point v = velocity_of(world, 0);
      EXPECT_NEAR(length_of(v), 2 + 6 * (1 - step * dt / 6), 1e-4) << step;
      EXPECT_NEAR(v[0] * heading[1] - v[1] * heading[0], 0, 1e-3) << "it turned in step " << step;
    }
    EXPECT_EQ(clock_of(world, &Life::jump, 0), 0);
    for (int step = 0; step < cooldown; ++step) {
      EXPECT_GT(clock_of(world, &Life::rest, 0), 0);
      world.step();
      EXPECT_LE(length_of(velocity_of(world, 0)), 3.0001);
    }
    EXPECT_EQ(clock_of(world, &Life::rest, 0), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Steps, Clocks, testing::Values(1.0, 0.5, 0.7, 0.1, 1.0 / 60));

TEST(Jump, NeedsHungerAndAPreyNearAheadAndCanBeSwitchedOff) {
  ScenarioDef scenario = still_world();
  scenario.flocks[0].body_radius = 0;
  scenario.flocks[0].hunger = Hunger{};
  scenario.flocks[0].jump = Jump{.distance = 30, .field_of_view = 60};
  const auto jumps = [](const ScenarioDef& in, float x, float y, double full) {
    State state = state_of(2, {{{0, 0}, {0, 1}, 0}, {{x, y}, {0, 0}, 1}});
    state.life.full = {full, 0};
    state.life.fasting = {0, 0};
    Simulation world = world_from(in, state);
    world.step();
    return length_of(velocity_of(world, 0)) > 5;
  };
  EXPECT_TRUE(jumps(scenario, 0, 20, 0));
  EXPECT_FALSE(jumps(scenario, 0, 20, 10)) << "full";
  EXPECT_FALSE(jumps(scenario, 0, 31, 0)) << "far";
  EXPECT_FALSE(jumps(scenario, 20, 0, 0)) << "aside";
  scenario.flocks[0].jump->on = false;
  EXPECT_FALSE(jumps(scenario, 0, 20, 0)) << "off";
}

/// Fish that lie on food.
ScenarioDef feeding(std::int64_t cap, std::int64_t births = 1) {
  ScenarioDef scenario = bare();
  scenario.flocks[0].body_radius = 1;
  scenario.flocks[0].start.min_speed = scenario.flocks[0].start.max_speed = 2;
  scenario.flocks[0].feed =
      Feed{.on = "food", .radius = 50, .weight = 0, .births = births, .population_cap = cap};
  scenario.food.push_back(FoodDef{});
  scenario.food[0].count = 0;
  return scenario;
}

TEST(Feed, PullsTowardThePiecesWithinItsRadius) {
  ScenarioDef scenario = feeding(10);
  scenario.flocks[0].feed->weight = 0.5;
  scenario.space.boundary.kind = BoundaryKind::wrap;
  State state = state_of(2, {{{990, 0}, {0, 2}, 0}});
  // 30 ahead over the seam, 40 to the left, and one too far.
  state.food = {{1, 2, 3}, {0, 0, 0}, {{{-980, 990, 990}, {0, -40, 51}, {}}}};
  state.next_id = 4;
  Simulation world = world_from(scenario, state);
  world.step();
  const Point v = velocity_of(world, 0);
  EXPECT_NEAR(v[0], 0.5 * (0.5 - 0), 1e-6);
  EXPECT_NEAR(v[1], 2 + 0.5 * (-0.5 - 1), 1e-6);
}

TEST(Feed, WhoTouchesEatsAndABoidIsBornBesideThePiece) {
  Simulation world = world_of(feeding(10), {{{0, 0}, {0, 0}, 0}, {{500, 0}, {0, 0}, 0}});
  must(world.push(AddFood{"food", 1, {2, 1}, 0}));
  EXPECT_EQ(world.view().state().food.size(), 1u);
  world.step();
  EXPECT_EQ(world.view().state().food.size(), 0u);
  ASSERT_EQ(ids_of(world), (std::set<std::uint64_t>{0, 1, 3})) << "the piece had id 2";
  EXPECT_NEAR(distance(position_of(world, 3), {2, 1, 0}), 3, 1e-5) << "body radii 1 and 2";
  EXPECT_NEAR(length_of(velocity_of(world, 3)), 2, 1e-5);
  EXPECT_TRUE(world.view().has_previous());
  EXPECT_EQ(world.view().previous_position(world.view().slot(3).value()), position_of(world, 3));
}

TEST(Feed, NobodyIsBornBeyondTheCapAndThatIsTold) {
  Simulation world = world_of(feeding(4, 3), {{{0, 0}, {0, 0}, 0}});
  must(world.push(AddFood{"food", 2, {1, 0}, 0}));
  world.step();
  EXPECT_EQ(world.view().size(), 4u);
  EXPECT_EQ(world.report().births_refused, 0u);
  world.run(3);
  EXPECT_EQ(world.view().size(), 4u);
  EXPECT_EQ(world.view().state().food.size(), 0u);
  EXPECT_EQ(world.report().births_refused, 3u);
}

TEST(Feed, ThePieceGoesToTheLowestIdThatTouchesIt) {
  ScenarioDef scenario = feeding(10);
  scenario.flocks.push_back(scenario.flocks[0]);
  scenario.flocks[1].name = "others";
  scenario.flocks[1].feed->births = 2;
  Simulation world = world_of(scenario, {{{2, 0}, {0, 0}, 1}, {{0.5f, 0}, {0, 0}, 0}});
  must(world.push(AddFood{"food", 1, {0, 0}, 0}));
  world.step();
  EXPECT_EQ(members(world, 1), 3u);
  EXPECT_EQ(members(world, 0), 1u);
}

TEST_P(Clocks, RandomFoodComesWheneverItsTimeIsOver) {
  const double dt = GetParam();
  ScenarioDef scenario = feeding(10);
  scenario.time.dt = dt;
  scenario.food[0].random = {.every = 2, .count = 3};
  Simulation world = world_of(scenario, {{{0, 0}, {0, 0}, 0}});
  for (int step = 1; step <= 200; ++step) {
    world.step();
    const auto due = static_cast<std::size_t>(3 * std::floor((step + 1e-6) * dt / 2));
    ASSERT_EQ(world.view().state().food.size(), due) << "step " << step;
  }
}

TEST(Erase, TakesFoodToo) {
  Simulation world = world_of(feeding(10), {{{0, 0}, {0, 0}, 0}});
  must(world.push(AddFood{"food", 20, {300, 0}, 10}));
  must(world.push(AddFood{"food", 5, {600, 0}, 10}));
  must(world.push(EraseBoids{{300, 0}, 11}));
  EXPECT_EQ(world.view().state().food.size(), 5u);
}

ScenarioDef small_sea(const char* kind = "grid") {
  ScenarioDef scenario = take(load_scenario("sharks-and-fish"));
  set(scenario, "flock.fish.count", "150");
  set(scenario, "flock.sharks.hunger.full_for", "20");
  set(scenario, "flock.sharks.hunger.starves_after", "150");
  set(scenario, "food.plankton.random.every", "5");
  set(scenario, "index.kind", kind);
  return scenario;
}

TEST(Sea, IsTheSameForAnyThreadsInstructionSetAndGarbage) {
  const IsaGuard guard;
  ScenarioDef scenario = small_sea();
  set(scenario, "flock.sharks.hunt.choose", "nearest");
  set(scenario, "flock.sharks.hunt.aim", "intercept");
  set(scenario, "flock.sharks.hunt.confusion", "0.01");
  ASSERT_TRUE(use_isa(Isa::plain));
  Simulation one = start(scenario, 1);
  Simulation three = start(scenario, 3);
  const std::size_t at_start = one.view().size();
  std::size_t births = 0;
  for (int step = 0; step < 300; ++step) {
    ASSERT_TRUE(use_isa(Isa::plain));
    const std::uint64_t next_id = one.view().state().next_id;
    one.step();
    births += one.view().state().next_id > next_id ? 1 : 0;
    ASSERT_TRUE(use_isa(Isa::best));
    three.poison_scratch();
    three.step();
    ASSERT_EQ(one.hash(), three.hash()) << "step " << step;
  }
  EXPECT_GT(births, 10u) << "the test is to see births";
  EXPECT_NE(one.view().size(), at_start);
}

TEST(Sea, EveryIndexFeedsTheSameAtFirst) {
  Simulation grid = start(small_sea());
  Simulation tree = start(small_sea("tree"));
  Simulation pairs = start(small_sea("all-pairs"));
  for (int step = 0; step < 40; ++step) {
    for (Simulation* world : {&grid, &tree, &pairs}) world->step();
    ASSERT_EQ(ids_of(grid), ids_of(pairs)) << step;
    ASSERT_EQ(ids_of(tree), ids_of(pairs)) << step;
  }
}

TEST(Sea, GoesOnFromAFileBitForBit) {
  ScenarioDef scenario = small_sea();
  set(scenario, "flock.sharks.hunt.choose", "nearest");
  scenario.run.events = {{50, AddFood{"plankton", 10, {400, 300}, 50}}};
  Simulation whole = start(scenario);
  whole.run(100);
  scenario.run.initial = "saved";
  scenario.run.first_step = 100;
  scenario.run.resumed = true;
  SimulationOptions options;
  options.tables["saved"] = through_csv(whole.view().state());
  Simulation rest = take(Simulation::create(scenario, options));
  ASSERT_EQ(rest.hash(), whole.hash());
  for (int step = 0; step < 200; ++step) {
    whole.step();
    rest.step();
    ASSERT_EQ(rest.hash(), whole.hash()) << step;
  }
}

TEST(Sea, RewindsAndReplays) {
  Simulation world = start(small_sea());
  world.run(60);
  const Snapshot snapshot = world.snapshot();
  const std::uint64_t then = world.hash();
  world.run(150);
  const std::uint64_t later = world.hash();
  world.restore(snapshot);
  EXPECT_EQ(world.hash(), then);
  world.run(150);
  EXPECT_EQ(world.hash(), later);
}

TEST(Sea, SwitchingPartsOnAndOffOnTheWayLosesNobody) {
  Simulation world = start(small_sea());
  world.run(30);
  for (const auto& [path, value] :
       std::vector<std::pair<std::string, std::string>>{{"flock.sharks.jump.on", "false"},
                                                        {"flock.fish.flee.on", "false"},
                                                        {"flock.sharks.hunt.on", "false"},
                                                        {"flock.sharks.hunt.choose", "nearest"},
                                                        {"flock.sharks.hunt.on", "true"},
                                                        {"flock.fish.wander.weight", "0.01"},
                                                        {"flock.sharks.jump.on", "true"}}) {
    const auto before = ids_of(world);
    const std::size_t food = world.view().state().food.size();
    must(world.push(SetParameter{path, value}));
    EXPECT_EQ(ids_of(world), before) << path;
    EXPECT_EQ(world.view().state().food.size(), food) << path;
    world.run(20);
    EXPECT_TRUE(all_finite(world.view().state()));
  }
}

class FullSea : public testing::TestWithParam<int> {};

TEST_P(FullSea, SharksStarveWhereMealsAreTooRareAndLiveWhereTheyAreNot) {
  for (const auto& [starves_after, sharks] :
       std::vector<std::pair<const char*, std::size_t>>{{"600", 0}, {"1800", 4}}) {
    ScenarioDef scenario = take(load_scenario("sharks-and-fish"));
    set(scenario, "seed", std::to_string(GetParam()));
    set(scenario, "flock.sharks.hunger.starves_after", starves_after);
    Simulation world = start(scenario);
    world.run(20000);
    EXPECT_EQ(members(world, 1), sharks) << starves_after;
    EXPECT_GT(members(world, 0), 100u) << starves_after;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, FullSea, testing::Values(1, 2, 3));

/// Pages of memory in use, where the system tells.
double megabytes_in_use() {
  std::ifstream file("/proc/self/statm");
  double all = 0, resident = 0;
  file >> all >> resident;
  return resident * 4096 / 1e6;
}

/// A small sea in which eating, starving and births go on: plankton enough for the shoal to grow back to its
/// cap, one shark that never starves, and others that do.
ScenarioDef lasting_sea() {
  ScenarioDef scenario = take(load_scenario("sharks-and-fish"));
  for (const auto& [path, value] :
       std::vector<std::pair<const char*, const char*>>{{"flock.fish.count", "40"},
                                                        {"flock.fish.feed.population_cap", "50"},
                                                        {"flock.sharks.count", "1"},
                                                        {"flock.sharks.hunger.starves_after", "inf"},
                                                        {"food.plankton.random.every", "20"}})
    set(scenario, path, value);
  scenario.flocks.push_back(scenario.flocks[1]);
  scenario.flocks[2].name = "strangers";
  scenario.flocks[2].count = 2;
  scenario.flocks[2].hunger->starves_after = 600;
  return scenario;
}

/// What has happened so far, and who lives.
struct Census {
  StepReport report;
  std::set<std::uint64_t> ids;
  std::uint64_t next_id = 0;
};

Census census_of(const Simulation& world) {
  return {world.report(), ids_of(world), world.view().state().next_id};
}

// Between two looks at the sea.
void expect_balance(const Census& then, const Census& now, std::size_t come) {
  ASSERT_EQ(
      then.ids.size() + come + (now.report.born - then.report.born),
      now.ids.size() + (now.report.eaten - then.report.eaten) + (now.report.starved - then.report.starved));
  for (const std::uint64_t id : now.ids) {
    ASSERT_LT(id, now.next_id);
    ASSERT_TRUE(id >= then.next_id || then.ids.count(id) == 1) << "id " << id << " came back";
  }
}

TEST(FullSeaForLong, NothingIsLostLeaksOrGoesBadInAMillionSteps) {
  Simulation world = start(lasting_sea());
  Census then = census_of(world), long_ago = then;
  double megabytes = 0;
  for (int step = 0; step < 1000000; step += 100) {
    const bool somebody_comes = step % 5000 == 0;
    if (somebody_comes) must(world.push(AddBoids{"strangers", 1, {400, 300}, 100}));
    world.run(100);
    const Census now = census_of(world);
    expect_balance(then, now, somebody_comes ? 1 : 0);
    ASSERT_FALSE(testing::Test::HasFatalFailure()) << "step " << step;
    ASSERT_TRUE(all_finite(world.view().state()));
    ASSERT_EQ(now.ids.size(), world.view().size());
    ASSERT_EQ(now.report.quarantined, 0u);
    ASSERT_LE(members(world, 0), 50u);
    then = now;
    if ((step + 100) % 100000 != 0) continue;
    // Life has gone on all the while.
    EXPECT_GT(now.report.born, long_ago.report.born + 200) << "step " << step;
    EXPECT_GT(now.report.eaten, long_ago.report.eaten + 200) << "step " << step;
    EXPECT_GT(now.report.starved, long_ago.report.starved + 10) << "step " << step;
    if (megabytes == 0) megabytes = megabytes_in_use();
    EXPECT_LT(megabytes_in_use(), megabytes + 4) << "step " << step;
    long_ago = now;
  }
}

}  // namespace
}  // namespace sturnus::test
