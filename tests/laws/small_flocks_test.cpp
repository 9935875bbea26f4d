// Laws of small flocks: nobody, one, two, all at one point, all at rest, and flocks that feel nothing.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support.h"

namespace sturnus::test {
namespace {

const std::vector<BoundaryKind> boundaries = {BoundaryKind::open, BoundaryKind::wrap, BoundaryKind::turn,
                                              BoundaryKind::bounce};
const std::vector<IndexKind> indexes = {IndexKind::grid, IndexKind::tree, IndexKind::all_pairs};

/// A flock of every term that looks at neighbours, in a space of [-500, 500].
ScenarioDef sociable(int dimensions) {
  ScenarioDef scenario = bare(dimensions);
  scenario.space.min = Coordinates(static_cast<std::size_t>(dimensions), -500.0);
  scenario.space.max = Coordinates(static_cast<std::size_t>(dimensions), 500.0);
  FlockDef& flock = scenario.flocks.front();
  flock.separation = {{}, {.combine = Combine::mean}};
  flock.alignment = {
      {}, {.count_self = true}, {.match = Match::heading, .relative = false}, {.radius = infinity}};
  flock.cohesion = {{}, {.strength = Strength::fades, .count_self = true}, {.radius = infinity}};
  return scenario;
}

Placed random_boid(int dimensions) {
  Placed boid;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
    boid.position[axis] = static_cast<float>(*rc::gen::inRange(-100, 100));
    boid.velocity[axis] = static_cast<float>(*rc::gen::inRange(-100, 100)) / 50;
  }
  return boid;
}

TEST(Nobody, IsAWorldToo) {
  for (const int dimensions : {2, 3}) {
    for (const BoundaryKind boundary : boundaries) {
      for (const IndexKind index : indexes) {
        ScenarioDef scenario;
        scenario.space.dimensions = dimensions;
        scenario.space.boundary.kind = boundary;
        scenario.index.kind = index;
        scenario.flocks.front().count = 0;
        Simulation simulation = start(scenario, 3);
        simulation.run(3);
        EXPECT_EQ(simulation.view().size(), 0u);
        EXPECT_EQ(simulation.step_number(), 3u);
      }
    }
  }
}

RC_GTEST_PROP(Alone, FeelsNoNeighbourTerm, ()) {
  const int dimensions = *rc::gen::inRange(2, 4);
  ScenarioDef scenario = sociable(dimensions);
  scenario.index.kind = *rc::gen::elementOf(indexes);
  const Placed boid = random_boid(dimensions);
  Simulation simulation = world_of(scenario, {boid});
  simulation.run(7);
  RC_ASSERT(velocity_of(simulation, 0) == boid.velocity);
}

TEST(Alone, InItsOwnShadowOverASmallWrappedSpaceFeelsNothing) {
  ScenarioDef scenario = sociable(2);
  scenario.flocks.front().cohesion.pop_back();  // a whole population has no centre where space wraps
  scenario.space.min = {0, 0};
  scenario.space.max = {10, 10};  // smaller than any radius
  scenario.space.boundary.kind = BoundaryKind::wrap;
  Simulation simulation = world_of(scenario, {{{1, 1}, {3, -2}}});
  simulation.run(20);
  EXPECT_EQ(velocity_of(simulation, 0), (Point{3, -2, 0}));
}

RC_GTEST_PROP(Two, FeelOppositeSeparationAndCohesion, ()) {
  const int dimensions = *rc::gen::inRange(2, 4);
  ScenarioDef scenario = bare(dimensions);
  scenario.flocks.front().separation = {{.radius = 300}};
  scenario.flocks.front().cohesion = {{.radius = 300}};
  Placed one = random_boid(dimensions), other = random_boid(dimensions);
  one.velocity = other.velocity = {};
  const Point first = felt_by(scenario, {one, other}, 0);
  const Point second = felt_by(scenario, {one, other}, 1);
  for (std::size_t axis = 0; axis < 3; ++axis) RC_ASSERT(first[axis] == -second[axis]);
}

RC_GTEST_PROP(Two, MeetHalfwayInTheirVelocities, ()) {
  ScenarioDef scenario = bare();
  scenario.flocks.front().alignment = {{.weight = 0.5, .radius = 300}};
  const Placed one = random_boid(2), other = random_boid(2);
  Simulation simulation = world_of(scenario, {one, other});
  simulation.step();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    RC_ASSERT(std::abs(velocity_of(simulation, 0)[axis] - (one.velocity[axis] + other.velocity[axis]) / 2) <
              1e-5f);
  }
  RC_ASSERT(distance(velocity_of(simulation, 0), velocity_of(simulation, 1)) < 1e-5);
}

RC_GTEST_PROP(Weightless, FlyStraightOn, ()) {
  const int dimensions = *rc::gen::inRange(2, 4);
  ScenarioDef scenario = sociable(dimensions);
  scenario.index.kind = *rc::gen::elementOf(indexes);
  FlockDef& flock = scenario.flocks.front();
  for (Separation& term : flock.separation) term.weight = 0;
  for (Alignment& term : flock.alignment) term.weight = 0;
  for (Cohesion& term : flock.cohesion) term.weight = 0;
  flock.cruise = Cruise{.speed = 9, .weight = 0};
  flock.wander = Wander{.weight = 0};
  std::vector<Placed> boids;
  for (int i = *rc::gen::inRange(0, 30); i > 0; --i) boids.push_back(random_boid(dimensions));
  Simulation simulation = world_of(scenario, boids);
  simulation.run(10);
  for (std::uint64_t id = 0; id < boids.size(); ++id) {
    RC_ASSERT(velocity_of(simulation, id) == boids[id].velocity);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double straight = double{boids[id].position[axis]} + 10 * double{boids[id].velocity[axis]};
      RC_ASSERT(std::abs(position_of(simulation, id)[axis] - straight) < 1e-3);
    }
  }
}

TEST(Coincident, AllAtOnePointStayNumbersInEveryWorld) {
  for (const int dimensions : {2, 3}) {
    for (const BoundaryKind boundary : boundaries) {
      for (const IndexKind index : indexes) {
        ScenarioDef scenario;
        scenario.space.dimensions = dimensions;
        scenario.space.boundary.kind = boundary;
        scenario.index.kind = index;
        scenario.flocks.front().field_of_view = 200;
        std::vector<Placed> boids(50, {{1, 2, 0}, {1, 0, 0}});
        Simulation simulation = world_of(scenario, boids);
        simulation.run(5);
        EXPECT_TRUE(all_finite(simulation.view().state()));
        EXPECT_EQ(simulation.report().quarantined, 0u);
        EXPECT_EQ(velocity_of(simulation, 0), velocity_of(simulation, 49));  // nothing tells them apart
      }
    }
  }
}

TEST(AtRest, NobodyInventsADirection) {
  ScenarioDef scenario = sociable(3);
  FlockDef& flock = scenario.flocks.front();
  flock.min_speed = 1;
  flock.max_speed = 2;
  flock.cruise = Cruise{};
  Simulation simulation = world_of(scenario, std::vector<Placed>(10, {{4, 5, 6}, {0, 0, 0}}));
  simulation.run(5);
  for (std::uint64_t id = 0; id < 10; ++id) {
    EXPECT_EQ(velocity_of(simulation, id), (Point{0, 0, 0}));
    EXPECT_EQ(position_of(simulation, id), (Point{4, 5, 6}));
  }
}

TEST(AtRest, OneIsCarriedAlongByTheOthers) {
  ScenarioDef scenario = bare();
  scenario.flocks.front().alignment = {{.weight = 1}};
  scenario.flocks.front().field_of_view = 90;
  EXPECT_EQ(felt_by(scenario, {{{0, 0}}, {{-5, 0}, {2, 0}}}), (Point{2, 0, 0}));  // at rest it sees behind
}

TEST(RadiusZero, OfEveryTermIsAFlockOfStrangers) {
  ScenarioDef scenario;
  FlockDef& flock = scenario.flocks.front();
  flock.count = 100;
  flock.separation.front().radius = flock.alignment.front().radius = flock.cohesion.front().radius = 0;
  Simulation simulation = start(scenario);
  const State before = simulation.view().state();
  simulation.run(5);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Point v = velocity_of(simulation, before.id[i]);
    const double speed = std::hypot(before.velocity[0][i], before.velocity[1][i]);
    EXPECT_NEAR(length_of(v), std::max(flock.min_speed, speed), 1e-5);
  }
}

}  // namespace
}  // namespace sturnus::test
