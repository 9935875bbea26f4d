// Motion in lanes against motion boid by boid, bit for bit: flocks of every size, so that each tail of a
// register is met, mixed groups, boids out of play and boids that go bad on the way.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "isas.h"
#include "support.h"

namespace sturnus::test {
namespace {

class MotionInLanes : public testing::TestWithParam<NamedIsa> {
 protected:
  void SetUp() override {
    if (!use_isa(GetParam().isa)) GTEST_SKIP() << "this machine has no " << GetParam().name;
  }
  IsaGuard guard_;
};

/// Three flocks that feel their neighbours and are limited each in its own way.
ScenarioDef three_flocks(int dimensions, BoundaryKind boundary) {
  ScenarioDef scenario = bare(dimensions);
  scenario.space.boundary.kind = boundary;
  scenario.space.boundary.margin = {30};
  scenario.space.boundary.strength = 0.7;
  scenario.time.dt = 0.75;
  FlockDef unlimited = scenario.flocks.front();
  unlimited.name = "unlimited";
  unlimited.separation = {{.weight = 3, .radius = 300}};
  unlimited.alignment = {{.radius = 400}, {.radius = 400, .match = Match::heading, .count_self = true}};
  unlimited.cohesion = {{.weight = 0.1, .radius = 500}};
  unlimited.cruise = Cruise{};
  FlockDef limited = unlimited;
  limited.name = "limited";
  limited.min_speed = 1;
  limited.max_speed = 2;
  limited.max_acceleration = 0.3;
  FlockDef slow = unlimited;
  slow.name = "slow";
  slow.max_speed = 0.01;
  slow.noise = Noise{.acceleration = 0.1};
  scenario.flocks = {unlimited, limited, slow};
  return scenario;
}

enum class Trouble { none, far, fast, out_of_play, bad_numbers };
constexpr Trouble every_trouble[] = {Trouble::none, Trouble::far, Trouble::fast, Trouble::out_of_play,
                                     Trouble::bad_numbers};

/// Boids near one another, some of them in trouble.
State random_state(int dimensions, std::size_t count, int flocks, Trouble trouble, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto number = [&random](float most) {
    return most * (static_cast<float>(random() >> 8) * 0x1p-23f - 1);
  };
  std::vector<Placed> boids(count);
  for (Placed& boid : boids) {
    boid.flock = static_cast<int>(random() % static_cast<unsigned>(flocks));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      boid.position[axis] = number(999);
      boid.velocity[axis] = random() % 9 == 0 ? 0 : number(3);
    }
    if (random() % 5 != 0) continue;
    if (trouble == Trouble::far) boid.position[0] = random() % 2 == 0 ? 1e15f : -9.99e14f;
    if (trouble == Trouble::fast) boid.velocity[1] = random() % 2 == 0 ? 1e15f : -9e14f;
    if (trouble == Trouble::bad_numbers) boid.velocity[random() % 2] = random() % 2 == 0 ? HUGE_VALF : NAN;
  }
  State state = state_of(dimensions, boids);
  for (auto& quarantined : state.quarantined)
    quarantined = trouble == Trouble::out_of_play && random() % 4 == 0 ? 1 : 0;
  return state;
}

/// Pushes every seventh boid beyond what a float may hold, one step after the other.
void push_hard(const View& view, Accelerations& out) {
  constexpr float pushes[] = {HUGE_VALF, -1e38f, NAN, 1e20f, 3e15f};
  for (std::size_t i = 0; i < view.size(); ++i) {
    if (view.id(i) % 7 == view.step() % 7) out.add(i, pushes[view.id(i) % 5], 1);
  }
}

/// Steps a world on one instruction set beside the plain loop; returns how many boids are out of play.
std::size_t run_side_by_side(const ScenarioDef& scenario, const State& state, Isa isa, bool with_pushes,
                             const std::string& what) {
  Simulation plain = world_from(scenario, state);
  Simulation wide = world_from(scenario, state, 2);
  if (with_pushes) {
    plain.add_rule("push", 0, push_hard);
    wide.add_rule("push", 0, push_hard);
  }
  for (int step = 0; step < 3; ++step) {
    use_isa(Isa::plain);
    plain.step();
    use_isa(isa);
    wide.step();
    EXPECT_EQ(wide.hash(), plain.hash()) << what << ", step " << step;
    EXPECT_EQ(wide.report().quarantined, plain.report().quarantined) << what << ", step " << step;
    EXPECT_TRUE(all_finite(wide.view().state())) << what << ", step " << step;
  }
  return plain.report().quarantined;
}

constexpr BoundaryKind boundaries[] = {BoundaryKind::open, BoundaryKind::wrap, BoundaryKind::turn,
                                       BoundaryKind::bounce};

TEST_P(MotionInLanes, MovesFlocksOfEverySizeAlike) {
  for (std::size_t count = 1; count <= 40; ++count) {
    for (const BoundaryKind boundary : boundaries) {
      const int dimensions = count % 2 == 0 ? 2 : 3;
      const std::string what =
          std::to_string(count) + " boids, boundary " + std::to_string(static_cast<int>(boundary));
      const State state =
          random_state(dimensions, count, 1, Trouble::none, 100 + static_cast<unsigned>(count));
      run_side_by_side(three_flocks(dimensions, boundary), state, GetParam().isa, false, what);
    }
  }
}

TEST_P(MotionInLanes, MovesMixedGroupsAlike) {
  for (std::size_t count = 1; count <= 40; ++count) {
    for (const Trouble trouble : every_trouble) {
      const State state = random_state(3, count, 3, trouble, 200 + static_cast<unsigned>(count));
      const std::string what =
          std::to_string(count) + " boids, trouble " + std::to_string(static_cast<int>(trouble));
      run_side_by_side(three_flocks(3, BoundaryKind::open), state, GetParam().isa, false, what);
    }
  }
}

TEST_P(MotionInLanes, PutsTheSameBoidsOutOfPlay) {
  std::size_t fallen = 0;
  for (std::size_t count = 1; count <= 40; ++count) {
    for (const Trouble trouble : every_trouble) {
      const State state = random_state(2, count, 3, trouble, 300 + static_cast<unsigned>(count));
      const std::string what =
          std::to_string(count) + " pushed boids, trouble " + std::to_string(static_cast<int>(trouble));
      const BoundaryKind boundary = boundaries[count % 4];
      fallen += run_side_by_side(three_flocks(2, boundary), state, GetParam().isa, true, what);
    }
  }
  EXPECT_GT(fallen, 500u) << "too few boids went bad for a proof";
}

// A block has 64 batches of 16: its tail lies elsewhere than the flock's.
TEST_P(MotionInLanes, MovesManyBlocksAlike) {
  for (const Trouble trouble : every_trouble) {
    const State state = random_state(2, 1300, 3, trouble, 7);
    run_side_by_side(three_flocks(2, BoundaryKind::wrap), state, GetParam().isa, true, "many blocks");
  }
}

INSTANTIATE_TEST_SUITE_P(On, MotionInLanes, testing::ValuesIn(wide_isas),
                         [](const auto& machine) { return machine.param.name; });

}  // namespace
}  // namespace sturnus::test
