// Laws of symmetry: moving, turning, mirroring or renaming the world does the same to the answer.
//
// Places and velocities are multiples of a power of two, and boids stand in one order (all pairs), so that
// most of these laws hold to the last bit.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "support.h"

namespace sturnus::test {
namespace {

/// A flock of every neighbour term, without noise, in an open world.
ScenarioDef flocking(int dimensions) {
  ScenarioDef scenario;
  scenario.space.dimensions = dimensions;
  scenario.space.min = Coordinates(static_cast<std::size_t>(dimensions), -4096.0);
  scenario.space.max = Coordinates(static_cast<std::size_t>(dimensions), 4096.0);
  scenario.space.boundary.kind = BoundaryKind::open;
  scenario.index.kind = IndexKind::all_pairs;
  FlockDef& flock = scenario.flocks.front();
  flock.field_of_view = 250;
  flock.alignment.push_back(
      {.weight = 0.05, .radius = 40, .inner = 10, .match = Match::heading, .count_self = true});
  flock.cohesion.push_back({.weight = 0.3, .radius = 50, .strength = Strength::fades});
  flock.cruise = Cruise{};
  return scenario;
}

std::vector<Placed> random_boids(int dimensions) {
  const auto count = *rc::gen::inRange<std::size_t>(1, 40);
  std::vector<Placed> boids(count);
  for (Placed& boid : boids) {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
      boid.position[axis] = static_cast<float>(*rc::gen::inRange(-2048, 2048)) / 64;
      boid.velocity[axis] = static_cast<float>(*rc::gen::inRange(-128, 128)) / 64;
    }
  }
  return boids;
}

template <class Change>
std::vector<Placed> changed(std::vector<Placed> boids, Change change) {
  for (Placed& boid : boids) change(boid);
  return boids;
}

/// Places and velocities by id after some steps.
std::vector<Placed> after(const ScenarioDef& scenario, const std::vector<Placed>& boids,
                          std::uint64_t steps) {
  Simulation simulation = world_of(scenario, boids);
  simulation.run(steps);
  std::vector<Placed> out;
  for (const std::uint32_t slot : simulation.view().slots_by_id()) {
    out.push_back({simulation.view().position(slot), simulation.view().velocity(slot)});
  }
  return out;
}

void expect_same(const std::vector<Placed>& found, const std::vector<Placed>& expected) {
  RC_ASSERT(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    RC_ASSERT(found[i].velocity == expected[i].velocity);
    RC_ASSERT(found[i].position == expected[i].position);
  }
}

RC_GTEST_PROP(Translation, MovesTheAnswerAlong, ()) {
  const int dimensions = *rc::gen::inRange(2, 4);
  const auto boids = random_boids(dimensions);
  const Point shift{64, -128, dimensions == 3 ? 256.0f : 0.0f};
  const auto moved = changed(boids, [&](Placed& boid) {
    for (std::size_t axis = 0; axis < 3; ++axis) boid.position[axis] += shift[axis];
  });
  for (const IndexKind index : {IndexKind::all_pairs, IndexKind::grid, IndexKind::tree}) {
    ScenarioDef scenario = flocking(dimensions);
    scenario.index.kind = index;
    const auto here = after(scenario, boids, 1);
    const auto there = after(scenario, moved, 1);
    for (std::size_t i = 0; i < boids.size(); ++i) {
      if (index == IndexKind::all_pairs) RC_ASSERT(here[i].velocity == there[i].velocity);
      RC_ASSERT(distance(here[i].velocity, there[i].velocity) < 1e-5);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        RC_ASSERT(std::abs(there[i].position[axis] - shift[axis] - here[i].position[axis]) < 1e-4f);
      }
    }
  }
}

RC_GTEST_PROP(Translation, ByAWholeTurnOfAWrappedSpaceChangesNothing, ()) {
  ScenarioDef scenario = flocking(2);
  scenario.space.min = {-32, -32};
  scenario.space.max = {32, 32};
  scenario.space.boundary.kind = BoundaryKind::wrap;
  const auto boids = random_boids(2);
  const auto moved = changed(boids, [](Placed& boid) {
    boid.position[0] += 64;
    boid.position[1] -= 128;
  });
  expect_same(after(scenario, moved, 5), after(scenario, boids, 5));
}

RC_GTEST_PROP(QuarterTurn, TurnsTheAnswer, ()) {
  const int dimensions = *rc::gen::inRange(2, 4);
  const auto turn = [](Placed& boid) {
    for (Point* v : {&boid.position, &boid.velocity}) *v = {-(*v)[1], (*v)[0], (*v)[2]};
  };
  const auto boids = random_boids(dimensions);
  const ScenarioDef scenario = flocking(dimensions);
  expect_same(after(scenario, changed(boids, turn), 5), changed(after(scenario, boids, 5), turn));
}

RC_GTEST_PROP(QuarterTurn, AboutAnotherAxisTooToRounding, ()) {
  const auto turn = [](Placed& boid) {
    for (Point* v : {&boid.position, &boid.velocity}) *v = {(*v)[0], -(*v)[2], (*v)[1]};
  };
  const auto boids = random_boids(3);
  const auto turned = after(flocking(3), changed(boids, turn), 1);
  const auto expected = changed(after(flocking(3), boids, 1), turn);
  for (std::size_t i = 0; i < boids.size(); ++i)
    RC_ASSERT(distance(turned[i].velocity, expected[i].velocity) < 1e-4);
}

RC_GTEST_PROP(Mirror, MirrorsTheAnswer, ()) {
  const int dimensions = *rc::gen::inRange(2, 4);
  const auto axis = *rc::gen::inRange<std::size_t>(0, static_cast<std::size_t>(dimensions));
  const auto mirror = [axis](Placed& boid) {
    boid.position[axis] = -boid.position[axis];
    boid.velocity[axis] = -boid.velocity[axis];
  };
  const auto boids = random_boids(dimensions);
  ScenarioDef scenario = flocking(dimensions);
  scenario.space.boundary = {
      *rc::gen::element(BoundaryKind::open, BoundaryKind::turn, BoundaryKind::bounce), {16}, 0.5};
  scenario.space.min = Coordinates(static_cast<std::size_t>(dimensions), -32.0);
  scenario.space.max = Coordinates(static_cast<std::size_t>(dimensions), 32.0);
  const auto found = after(scenario, changed(boids, mirror), 5);
  const auto expected = changed(after(scenario, boids, 5), mirror);
  if (scenario.space.boundary.kind != BoundaryKind::bounce) return expect_same(found, expected);
  for (std::size_t i = 0; i < boids.size(); ++i) {  // walls at 32 and -32 round in their own ways
    RC_ASSERT(distance(found[i].velocity, expected[i].velocity) < 1e-2);
  }
}

State shuffled(State state) {
  std::vector<std::size_t> order(state.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937(*rc::gen::arbitrary<unsigned>()));
  const State before = state;
  for (std::size_t i = 0; i < order.size(); ++i) {
    state.id[i] = before.id[order[i]];
    for (std::size_t axis = 0; axis < 3 && !state.position[axis].empty(); ++axis) {
      state.position[axis][i] = before.position[axis][order[i]];
      state.velocity[axis][i] = before.velocity[axis][order[i]];
    }
  }
  return state;
}

RC_GTEST_PROP(Relabelling, AnotherOrderOfStorageIsTheSameFlockToRounding, ()) {
  const int dimensions = *rc::gen::inRange(2, 4);
  ScenarioDef scenario = flocking(dimensions);
  scenario.index.kind = *rc::gen::element(IndexKind::grid, IndexKind::tree, IndexKind::all_pairs);
  const State state = state_of(dimensions, random_boids(dimensions));
  Simulation one = world_from(scenario, state), other = world_from(scenario, shuffled(state));
  RC_ASSERT(one.hash() == other.hash());
  one.step();
  other.step();
  for (std::uint64_t id = 0; id < state.size(); ++id) {
    RC_ASSERT(distance(velocity_of(one, id), velocity_of(other, id)) < 1e-4);
  }
}

RC_GTEST_PROP(Relabelling, AnotherOrderOfStorageIsTheSameHashWhereNothingIsSummed, ()) {
  ScenarioDef scenario = bare(3);
  FlockDef& flock = scenario.flocks.front();
  flock.cohesion = {{.weight = 0, .radius = 20}};  // so that the index sorts
  flock.cruise = Cruise{};
  flock.wander = Wander{};
  flock.noise = Noise{.acceleration = 0.1, .turn = 20};
  const State state = state_of(3, random_boids(3));
  Simulation one = world_from(scenario, state), other = world_from(scenario, shuffled(state));
  one.run(5);
  other.run(5);
  RC_ASSERT(one.hash() == other.hash());
}

RC_GTEST_PROP(Relabelling, OtherIdsAreTheSameFlockWithoutNoise, ()) {
  State state = state_of(2, random_boids(2));
  Simulation one = world_from(flocking(2), state);
  for (std::uint64_t& id : state.id) id = 5000 - 3 * id;
  Simulation other = world_from(flocking(2), state);
  one.run(3);
  other.run(3);
  for (std::size_t i = 0; i < state.size(); ++i) {
    RC_ASSERT(one.view().velocity(i) == other.view().velocity(i));
    RC_ASSERT(one.view().position(i) == other.view().position(i));
  }
}

}  // namespace
}  // namespace sturnus::test
