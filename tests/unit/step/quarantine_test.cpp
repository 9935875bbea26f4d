// Bad numbers: whoever meets one is put out of play and counted, and nobody else is spoiled.
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "support.h"

namespace sturnus::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float denormal = 1e-42f;

/// A flock that uses every kind of sum, so that a bad number has every way to spread.
ScenarioDef crowd(BoundaryKind boundary, IndexKind index, int dimensions = 2) {
  ScenarioDef scenario;
  scenario.space.dimensions = dimensions;
  scenario.space.boundary.kind = boundary;
  scenario.index.kind = index;
  FlockDef& flock = scenario.flocks.front();
  flock.count = 120;
  flock.alignment.push_back({.weight = 0.01, .radius = infinity, .match = Match::heading});
  if (boundary != BoundaryKind::wrap) flock.cohesion.push_back({.weight = 0.0001, .radius = infinity});
  flock.cruise = Cruise{};
  flock.wander = Wander{};
  flock.noise = Noise{.acceleration = 0.01, .turn = 3};
  flock.colour.averaging = 0.1;
  return scenario;
}

std::set<std::uint64_t> quarantined_in(const View& view) {
  std::set<std::uint64_t> ids;
  for (std::size_t i = 0; i < view.size(); ++i) {
    if (view.quarantined(i)) ids.insert(view.id(i));
  }
  return ids;
}

void expect_all_well_but(const Simulation& simulation, const std::set<std::uint64_t>& bad) {
  EXPECT_EQ(quarantined_in(simulation.view()), bad);
  EXPECT_EQ(simulation.report().quarantined, bad.size());
  EXPECT_TRUE(all_finite(simulation.view().state()));
  for (const std::uint64_t id : bad) EXPECT_EQ(velocity_of(simulation, id), (Point{0, 0, 0}));
}

const std::vector<BoundaryKind> boundaries = {BoundaryKind::open, BoundaryKind::wrap, BoundaryKind::turn,
                                              BoundaryKind::bounce};

TEST(Quarantine, ABadNumberInAnyArrayOfTheStartSpoilsNobodyElse) {
  for (const BoundaryKind boundary : boundaries) {
    for (const IndexKind index : {IndexKind::grid, IndexKind::tree, IndexKind::all_pairs}) {
      const ScenarioDef scenario = crowd(boundary, index, index == IndexKind::grid ? 3 : 2);
      const State good = start(scenario).view().state();
      for (const float bad : {nan, inf, -inf, 1e38f, -2e15f}) {
        for (const auto array : {&State::position, &State::velocity, &State::wander, &State::colour}) {
          State state = good;
          (state.*array)[1][17] = bad;
          Simulation simulation = world_from(scenario, state);
          simulation.run(3);
          SCOPED_TRACE(bad);
          expect_all_well_but(simulation, {17});
        }
      }
    }
  }
}

TEST(Quarantine, DenormalsAreNumbersLikeOthers) {
  const ScenarioDef scenario = crowd(BoundaryKind::wrap, IndexKind::grid);
  State state = start(scenario).view().state();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    state.position[axis][3] = state.velocity[axis][3] = state.velocity[axis][4] = denormal;
    state.position[axis][5] = -denormal;
  }
  Simulation simulation = world_from(scenario, state);
  simulation.run(5);
  expect_all_well_but(simulation, {});
}

TEST(Quarantine, ABadAccelerationStopsItsBoidAlone) {
  for (const BoundaryKind boundary : boundaries) {
    for (const float bad : {nan, inf, -inf}) {
      Simulation simulation = start(crowd(boundary, IndexKind::grid, 3));
      simulation.run(2);
      const Point before = position_of(simulation, 40);
      simulation.external().add(simulation.view().slot(40).value(), bad, 0);
      simulation.run(4);
      expect_all_well_but(simulation, {40});
      EXPECT_EQ(position_of(simulation, 40), before);  // its last good place
    }
  }
}

void expect_a_spoiling_rule_to_stop_whom_it_hits(int dimensions) {
  ScenarioDef scenario = crowd(BoundaryKind::turn, IndexKind::tree, dimensions);
  Simulation simulation = start(scenario);
  simulation.add_rule("spoil", 0, [](const View& view, Accelerations& out) {
    for (std::size_t i = 0; i < view.size(); ++i) {
      const std::uint64_t id = view.id(i);
      if (id % 10 == 0) out.add(i, id % 20 == 0 ? nan : inf, denormal);
      if (id % 10 == 1) out.add(i, 1e38f, -1e38f);  // absurd, but the cap makes a number of it
      if (id % 10 == 2) out.add(i, denormal, -denormal);
    }
  });
  simulation.run(5);
  std::set<std::uint64_t> hit;
  for (std::uint64_t id = 0; id < 120; id += 10) hit.insert(id);
  expect_all_well_but(simulation, hit);
}

TEST(Quarantine, ARuleThatWritesBadNumbersEverywhereStopsWhomItHits) {
  expect_a_spoiling_rule_to_stop_whom_it_hits(2);
  expect_a_spoiling_rule_to_stop_whom_it_hits(3);
}

TEST(Quarantine, WithoutLimitsHugeAccelerationsAreBadNumbersToo) {
  for (const int dimensions : {2, 3}) {
    ScenarioDef scenario = crowd(BoundaryKind::open, IndexKind::grid, dimensions);
    FlockDef& flock = scenario.flocks.front();
    flock.max_acceleration = infinity;
    for (const double max_speed : {3.0, infinity}) {
      flock.max_speed = max_speed;
      for (const float huge : {1e16f, 1e25f, 1e38f, 3e38f}) {
        Simulation simulation = start(scenario);
        simulation.external().add(5, huge, -huge, huge);
        simulation.run(3);
        EXPECT_TRUE(all_finite(simulation.view().state()));
        EXPECT_LE(simulation.report().quarantined, 1u);
        EXPECT_GE(simulation.report().quarantined, std::isinf(max_speed) ? 1u : 0u) << huge;
      }
    }
  }
}

TEST(Quarantine, AnUnlimitedBoidThatRunsAwayIsStoppedAtItsLastGoodPlace) {
  for (const BoundaryKind boundary : {BoundaryKind::open, BoundaryKind::wrap, BoundaryKind::bounce}) {
    ScenarioDef scenario = bare();
    scenario.space.boundary.kind = boundary;
    scenario.time.dt = 1e10;
    Simulation simulation = world_of(scenario, {{{1, 1}, {1e6f, 0}}, {{2, 2}, {1e-12f, 0}}});
    simulation.step();
    expect_all_well_but(simulation, {0});
    EXPECT_EQ(position_of(simulation, 0), (Point{1, 1, 0}));
  }
}

TEST(Quarantine, TheHiddenAreNeitherSeenNorMoved) {
  ScenarioDef scenario = bare();
  scenario.flocks.front().cohesion = {{.weight = 1, .radius = 10}, {.weight = 1, .radius = infinity}};
  Simulation simulation = world_of(scenario, {{{0, 0}}, {{2, 0}, {nan, 0}}, {{0, 4}}});
  simulation.step();
  EXPECT_EQ(velocity_of(simulation, 0), (Point{0, 8, 0}));
  EXPECT_EQ(position_of(simulation, 1), (Point{2, 0, 0}));
}

TEST(Quarantine, OnlyAMoveReleases) {
  Simulation simulation = world_of(bare(), {{{0, 0}, {1, 0}}, {{2, 0}, {nan, 0}}});
  simulation.run(3);
  expect_all_well_but(simulation, {1});
  must(simulation.push(SetParameter{"flock.boids.max_speed", "5"}));
  simulation.step();
  expect_all_well_but(simulation, {1});
  must(simulation.push(MoveBoid{1, {7, 7}, {0, 1}}));
  simulation.run(2);
  expect_all_well_but(simulation, {});
  EXPECT_EQ(position_of(simulation, 1), (Point{7, 9, 0}));
}

TEST(Quarantine, IsKnownFromTheStart) {
  const Simulation simulation = world_of(bare(), {{{nan, 0}}, {{1, 1}}});
  expect_all_well_but(simulation, {0});
  EXPECT_EQ(simulation.index_boxes().size(), 0u);
}

}  // namespace
}  // namespace sturnus::test
