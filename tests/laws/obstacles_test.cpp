// Laws of worlds with obstacles: the same bits from every kernel and any number of threads; placed and erased
// obstacles in recordings, snapshots and continued runs; the challenge of VUW.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sturnus/files.h>

#include <iostream>

#include "isas.h"
#include "support.h"

namespace sturnus::test {
namespace {

ScenarioDef rocky(int dimensions, ObstacleForm form, BoundaryKind boundary = BoundaryKind::wrap) {
  ScenarioDef scenario;
  scenario.space.dimensions = dimensions;
  scenario.space.boundary.kind = boundary;
  scenario.space.solid = true;
  scenario.obstacles.resize(1);
  scenario.obstacles[0].random = RandomObstacles{40, 1, 6, 1};
  FlockDef& flock = scenario.flocks.front();
  flock.count = 700;
  flock.avoid_obstacles = AvoidObstacles{.look_ahead = 20, .form = form, .radius = 12};
  flock.body_radius = 0.5;
  return scenario;
}

void expect_equal_bits(const ScenarioDef& scenario, int steps) {
  const IsaGuard guard;
  ASSERT_TRUE(use_isa(Isa::plain));
  Simulation plain = start(scenario);
  for (int step = 0; step < steps; ++step) plain.step();
  for (const NamedIsa& isa : wide_isas) {
    if (!use_isa(isa.isa)) continue;
    for (const int threads : {1, 2, 3}) {
      Simulation wide = start(scenario, threads);
      for (int step = 0; step < steps; ++step) {
        if (step % 3 == 2) wide.poison_scratch();
        wide.step();
      }
      EXPECT_EQ(wide.hash(), plain.hash()) << isa.name << ", " << threads << " threads";
    }
  }
}

TEST(ObstacleBits, AreTheSameOnEveryInstructionSetAndThreadCount) {
  for (const int dimensions : {2, 3}) {
    for (const ObstacleForm form : {ObstacleForm::sweep, ObstacleForm::heading}) {
      expect_equal_bits(rocky(dimensions, form), 12);
      expect_equal_bits(rocky(dimensions, form, BoundaryKind::bounce), 12);
    }
  }
}

TEST(ObstacleBits, AreTheSameUnderABudgetAndWithWandering) {
  ScenarioDef scenario = rocky(3, ObstacleForm::sweep);
  scenario.flocks.front().arbitration = Arbitration::budget;
  expect_equal_bits(scenario, 12);
  scenario.flocks.front().arbitration = Arbitration::weighted;
  scenario.flocks.front().wander = Wander{};
  expect_equal_bits(scenario, 12);
}

TEST(ObstacleBits, CountInTheHash) {
  const auto hash_with = [](const Coordinates& at, double radius) {
    Simulation simulation = start(ScenarioDef{});
    must(simulation.push(PlaceObstacle{at, radius}));
    return simulation.hash();
  };
  const std::uint64_t one = hash_with({1, 2}, 3);
  EXPECT_NE(one, start(ScenarioDef{}).hash());
  EXPECT_NE(one, hash_with({1, 2.5}, 3));
  EXPECT_NE(one, hash_with({1, 2}, 3.5));
  EXPECT_EQ(one, hash_with({1, 2}, 3));
}

// ---- commands ----

TEST(PlacedObstacles, AreFeltAndErasedByTheirCentres) {
  Simulation simulation = start(rocky(2, ObstacleForm::sweep));
  const std::size_t before = simulation.view().state().obstacles.size();
  must(simulation.push(PlaceObstacle{{3, 4}, 2}));
  ASSERT_EQ(simulation.view().state().obstacles.size(), before + 1);
  EXPECT_EQ(simulation.view().state().obstacles.back().at, (Point{3, 4, 0}));
  must(simulation.push(EraseBoids{{5, 4}, 1.9}));
  EXPECT_EQ(simulation.view().state().obstacles.back().at, (Point{3, 4, 0}));
  must(simulation.push(EraseBoids{{5, 4}, 2}));
  EXPECT_NE(simulation.view().state().obstacles.back().at, (Point{3, 4, 0}));
}

TEST(PlacedObstacles, AreRefusedWithASentence) {
  Simulation simulation = start(rocky(2, ObstacleForm::sweep));
  const auto error_of = [&](const PlaceObstacle& command) { return simulation.push(command).error(); };
  EXPECT_NE(error_of({{1, 2, 3}, 1}).find("the place must have 2 coordinates"), std::string::npos);
  EXPECT_NE(error_of({{1, 2}, 0}).find("the radius must be above 0"), std::string::npos);
  EXPECT_NE(error_of({{1, 2}, 1e4}).find("smaller than the wrapped space"), std::string::npos);
}

TEST(PlacedObstacles, StandInEvents) {
  ScenarioDef scenario =
      take(parse_scenario("[run]\nevents = [[3, \"obstacle\", [1, 2], 5]]\n[[flock]]\n", "rock.toml"));
  const std::string text = to_toml(scenario);
  EXPECT_NE(text.find("[3, \"obstacle\", [1, 2], 5]"), std::string::npos) << text;
  Simulation simulation = start(scenario);
  simulation.run(2);
  EXPECT_TRUE(simulation.view().state().obstacles.empty());
  simulation.run(1);
  EXPECT_EQ(simulation.view().state().obstacles.size(), 1u);
}

TEST(PlacedObstacles, DoNotMakeTheLastStepForgotten) {
  Simulation simulation = start(rocky(2, ObstacleForm::sweep));
  simulation.step();
  must(simulation.push(PlaceObstacle{{3, 4}, 2}));
  EXPECT_TRUE(simulation.view().has_previous());
}

const std::vector<std::pair<std::string, std::string>> settings = {
    {"flock.boids.wander.weight", "0.1"},
    {"space.per_boid", "140"},
    {"space.solid", "false"},
    {"flock.boids.body_radius", "0.9"},
    {"flock.boids.avoid_obstacles.look_ahead", "5"}};

Command random_command() {
  const auto place = [] {
    return Coordinates{*rc::gen::inRange(-130, 130) * 1.0, *rc::gen::inRange(-130, 130) * 1.0};
  };
  switch (*rc::gen::inRange(0, 5)) {
    case 0:
      return EraseBoids{place(), *rc::gen::inRange(0, 50) * 1.0};
    case 1:
      return AddBoids{"boids", *rc::gen::inRange(0, 20), place(), 10};
    case 2: {
      const auto [path, value] = *rc::gen::elementOf(settings);
      return SetParameter{path, value};
    }
    default:
      return PlaceObstacle{place(), *rc::gen::inRange(1, 10) * 1.0};
  }
}

void play(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) {
    for (int n = *rc::gen::inRange(0, 3); n > 0; --n) {
      const Status status = simulation.push(random_command());
      RC_ASSERT(status || !status.error().empty());
    }
    simulation.step();
  }
}

ScenarioDef small_rocky() {
  ScenarioDef scenario = rocky(2, *rc::gen::element(ObstacleForm::sweep, ObstacleForm::heading));
  scenario.flocks.front().count = 150;
  scenario.obstacles[0].random->count = 10;
  return scenario;
}

RC_GTEST_PROP(ObstacleSessions, ReplayFromTheirText, ()) {
  Simulation live = start(small_rocky());
  play(live, *rc::gen::inRange(0, 12));
  Simulation again = start(take(parse_scenario(to_toml(live.recording()), "session")), 3);
  again.run(live.step_number());
  RC_ASSERT(again.view().state().obstacles == live.view().state().obstacles);
  RC_ASSERT(again.hash() == live.hash());
}

RC_GTEST_PROP(ObstacleSessions, GoOnFromASnapshot, ()) {
  Simulation live = start(small_rocky());
  play(live, *rc::gen::inRange(0, 6));
  const Snapshot moment = live.snapshot();
  const std::uint64_t then = live.hash();
  play(live, *rc::gen::inRange(0, 6));
  const std::uint64_t end = live.step_number(), hash = live.hash();
  live.restore(moment);
  RC_ASSERT(live.hash() == then);
  live.run(end - live.step_number());
  RC_ASSERT(live.hash() == hash);
}

RC_GTEST_PROP(ObstacleSessions, AreContinuedFromTheirSavedBoids, ()) {
  Simulation live = start(small_rocky());
  play(live, *rc::gen::inRange(1, 8));
  const auto at = live.step_number();
  SimulationOptions options;
  options.threads = 1;
  options.tables["saved"] = take(parse_state_csv(state_csv(live.view().state()), "saved"));
  ScenarioDef scenario = live.recording();
  scenario.run.initial = "saved";
  scenario.run.first_step = static_cast<std::int64_t>(at);
  scenario.run.resumed = true;
  Simulation second = take(Simulation::create(scenario, options));
  RC_ASSERT(second.view().state().obstacles == live.view().state().obstacles);
  RC_ASSERT(second.hash() == live.hash());
  must(second.push(PlaceObstacle{{1, 1}, 3}));
  must(live.push(PlaceObstacle{{1, 1}, 3}));
  second.run(4);
  live.run(4);
  RC_ASSERT(second.hash() == live.hash());
  // And a recording of what was continued has them too.
  Simulation third =
      take(Simulation::create(take(parse_scenario(to_toml(second.recording()), "third")), options));
  third.run(4);
  RC_ASSERT(third.hash() == second.hash());
}

// ---- the challenge ----

std::size_t inside(const View& view) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < view.size(); ++i) {
    const Point at = view.position(i);
    bool is_inside = false;
    for (const Obstacle& sphere : view.state().obstacles) {
      double squared = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double o = std::abs(double{at[axis]} - double{sphere.at[axis]});
        squared += std::min(o, 40 - o) * std::min(o, 40 - o);
      }
      is_inside = is_inside || std::sqrt(squared) < (double{sphere.radius} + 0.25) * (1 - 1e-5);
    }
    count += is_inside ? 1 : 0;
  }
  return count;
}

double share_inside(bool solid, int steps, bool avoids = true) {
  ScenarioDef scenario = take(load_scenario("vuw-challenge"));
  scenario.space.solid = solid;
  scenario.flocks.front().avoid_obstacles->on = avoids;
  Simulation simulation = start(scenario, 2);
  std::size_t found = 0;
  for (int step = 0; step < steps; ++step) {
    simulation.step();
    found += inside(simulation.view());
  }
  return static_cast<double>(found) / (300.0 * steps);
}

TEST(VuwChallenge, WithSolidSpheresNobodyIsInside) {
  EXPECT_EQ(share_inside(true, 600), 0);
}

TEST(VuwChallenge, SteeringAloneKeepsNearlyAllContactAway) {
  const double share = share_inside(false, 3400);  // a million boid-steps
  RecordProperty("share_inside", std::to_string(share));
  EXPECT_LT(share, 1e-4);
  EXPECT_GT(share_inside(false, 300, false), 1e-2) << "there is nothing to avoid";
}

TEST(FullVuwChallenge, SteeringAloneKeepsNearlyAllContactAwayForLong) {
  for (const bool avoids : {true, false}) {
    const double share = share_inside(false, 10700, avoids);  // three million boid-steps
    std::cout << "share of boid-steps in contact, avoidance " << (avoids ? "on: " : "off: ") << share << "\n";
    if (avoids) {
      EXPECT_LT(share, 1e-4);
    }
  }
}

}  // namespace
}  // namespace sturnus::test
