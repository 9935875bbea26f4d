// Laws of replay: a session of random commands, recorded, ends in the same hash when it is run again, also
// through its text, also from the middle; working memory and thread count change nothing.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support.h"

namespace sturnus::test {
namespace {

ScenarioDef two_flocks() {
  ScenarioDef scenario;
  scenario.space.dimensions = *rc::gen::inRange(2, 4);
  scenario.space.boundary.kind =
      *rc::gen::element(BoundaryKind::open, BoundaryKind::wrap, BoundaryKind::bounce);
  scenario.seed = *rc::gen::inRange(0, 1000000);
  FlockDef& fish = scenario.flocks.front();
  fish.name = "fish";
  fish.count = *rc::gen::inRange(0, 60);
  fish.noise = Noise{.acceleration = 0.02};
  fish.cohesion.front().sample = 0.5;
  fish.avoid_obstacles = AvoidObstacles{};
  scenario.space.solid = *rc::gen::arbitrary<bool>();
  scenario.flocks.push_back(fish);
  FlockDef& hawks = scenario.flocks.back();
  hawks.name = "hawks";
  hawks.count = *rc::gen::inRange(0, 5);
  hawks.wander = Wander{};
  scenario.flocks.front().flee = {{.from = {"hawks"}}};
  return scenario;
}

Coordinates random_place(const ScenarioDef& scenario) {
  Coordinates at;
  for (std::int64_t axis = 0; axis < scenario.space.dimensions; ++axis)
    at.push_back(*rc::gen::inRange(-90, 90) * 0.9);
  return at;
}

const std::vector<std::pair<std::string, std::string>> settings = {{"flock.fish.max_speed", "3.3"},
                                                                   {"flock.fish.separation.weight", "-0.1"},
                                                                   {"flock.hawks.cohesion.on", "false"},
                                                                   {"flock.fish.separation.ring", "[2, 17]"},
                                                                   {"space.boundary", "wrap"},
                                                                   {"space.boundary.kind", "\"bounce\""},
                                                                   {"index.kind", "tree"},
                                                                   {"index", "grid"},
                                                                   {"flock.fish.wander.weight", "0.03"},
                                                                   {"flock.fish.noise.turn", "15"},
                                                                   {"flock.fish.colour.averaging", "0.2"},
                                                                   {"flock.fish.colour.averaging", "0"},
                                                                   {"time.dt", "0.7"},
                                                                   {"flock.hawks.alignment.of", "[fish]"},
                                                                   {"pointer.weight", "0.7"},
                                                                   {"space.per_boid", "111"},
                                                                   {"flock.fish.arbitration", "budget"},
                                                                   {"flock.hawks.field_of_view", "200"},
                                                                   {"title", "\"a \\\"b\\\" \\u0007\""}};

SetParameter random_setting() {
  const auto [path, value] = *rc::gen::elementOf(settings);
  return {path, value};
}

Command random_command(const Simulation& simulation) {
  const ScenarioDef& scenario = simulation.scenario();
  const Coordinates at = random_place(scenario);
  switch (*rc::gen::inRange(0, 7)) {
    case 0:
      return AddBoids{*rc::gen::element<std::string>("fish", "hawks"), *rc::gen::inRange(0, 9), at, 4.3};
    case 1:
      return EraseBoids{at, *rc::gen::inRange(0, 40) / 3.0};
    case 2:
      return MoveBoid{*rc::gen::inRange<std::uint64_t>(0, 80), at, random_place(scenario)};
    case 3:
      return MovePointer{*rc::gen::element(PointerMode::attract, PointerMode::repel), at,
                         *rc::gen::arbitrary<bool>()};
    case 4:
      return PlaceObstacle{at, *rc::gen::inRange(0, 20) / 2.0};
    default:
      return random_setting();
  }
}

/// Steps with random commands between them. Commands that the world refuses are part of a session too.
void play(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) {
    for (int n = *rc::gen::inRange(0, 3); n > 0; --n) {
      const Status status = simulation.push(random_command(simulation));
      RC_ASSERT(status || !status.error().empty());
    }
    simulation.step();
  }
}

void expect_same_run(const ScenarioDef& scenario, const Simulation& live, int threads) {
  Simulation again = start(scenario, threads);
  again.run(live.step_number());
  RC_ASSERT(again.view().size() == live.view().size());
  RC_ASSERT(again.hash() == live.hash());
}

RC_GTEST_PROP(Replay, ARecordedSessionEndsInTheSameHash, ()) {
  Simulation live = start(two_flocks());
  play(live, *rc::gen::inRange(0, 20));
  expect_same_run(live.recording(), live, 1);
  expect_same_run(live.recording(), live, 3);
}

RC_GTEST_PROP(Replay, SoDoesItsText, ()) {
  Simulation live = start(two_flocks());
  play(live, *rc::gen::inRange(0, 20));
  const std::string text = to_toml(live.recording());
  const Result<ScenarioDef> read = parse_scenario(text, "session.toml");
  RC_LOG(read ? text : read.error() + text);
  RC_ASSERT(static_cast<bool>(read));
  expect_same_run(*read, live, 1);
}

RC_GTEST_PROP(Replay, GoesOnFromASnapshot, ()) {
  Simulation live = start(two_flocks());
  play(live, *rc::gen::inRange(0, 8));
  const Snapshot moment = live.snapshot();
  const std::uint64_t then = live.hash();
  play(live, *rc::gen::inRange(0, 8));
  const std::uint64_t end = live.step_number(), hash = live.hash();
  live.restore(moment);
  RC_ASSERT(live.hash() == then);
  // Commands of the very moment were pushed after the snapshot: they are done when their step comes again.
  live.run(end - live.step_number());
  RC_ASSERT(live.hash() == hash);
}

RC_GTEST_PROP(Replay, ABranchIsARecordingToo, ()) {
  Simulation live = start(two_flocks());
  play(live, *rc::gen::inRange(0, 8));
  const Snapshot moment = live.snapshot();
  play(live, *rc::gen::inRange(0, 8));
  live.restore(moment);
  must(live.push(AddBoids{"fish", 2, random_place(live.scenario()), 1}));
  play(live, *rc::gen::inRange(0, 8));
  expect_same_run(live.recording(), live, 1);
}

RC_GTEST_PROP(Replay, GarbageInTheWorkingMemoryChangesNothing, ()) {
  Simulation live = start(two_flocks());
  play(live, *rc::gen::inRange(1, 12));
  Simulation poisoned = start(live.recording());
  while (poisoned.step_number() < live.step_number()) {
    poisoned.poison_scratch();
    poisoned.step();
  }
  RC_ASSERT(poisoned.hash() == live.hash());
}

}  // namespace
}  // namespace sturnus::test
