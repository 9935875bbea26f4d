// The world behind the window: what is done is undone to the bit, the past is found again, and the thread
// that carries it serves in order.
#include "session/session.h"

#include <gtest/gtest.h>
#include <sturnus/files.h>
#include <sturnus/parameters.h>

#include <map>

#include "session/playback.h"

namespace studio {
namespace {

using sturnus::AddBoids;
using sturnus::EraseBoids;
using sturnus::SetParameter;

sturnus::Simulation small_flock(std::int64_t count = 200) {
  auto scenario = sturnus::load_scenario("ucsd");
  scenario->flocks[0].count = count;
  return std::move(*sturnus::open_simulation(*scenario, 1));
}

constexpr std::size_t plenty = std::size_t{64} << 20;

void run(World& world, int steps) {
  for (int i = 0; i < steps; ++i) world.step();
}

void go(World& world, std::uint64_t step) {
  while (!world.go_to(step)) {
  }
}

std::string flock_of(const World& world) {
  return world.simulation().scenario().flocks[0].name;
}

TEST(StudioWorld, UndoingTakesTheWorldBackToTheMomentBefore) {
  World world(small_flock(), plenty);
  run(world, 10);
  const std::uint64_t before = world.simulation().hash();
  ASSERT_TRUE(world.act(AddBoids{flock_of(world), 8, {0, 0}, 5}, "add"));
  run(world, 10);
  const std::uint64_t after = world.simulation().hash();
  ASSERT_TRUE(world.undo());
  EXPECT_EQ(world.simulation().step_number(), 10u);
  EXPECT_EQ(world.simulation().hash(), before);
  ASSERT_TRUE(world.redo());
  EXPECT_EQ(world.simulation().step_number(), 20u);
  EXPECT_EQ(world.simulation().hash(), after);
  ASSERT_TRUE(world.undo());
  run(world, 10);
  World untouched(small_flock(), plenty);
  run(untouched, 20);
  EXPECT_EQ(world.simulation().hash(), untouched.simulation().hash());
}

TEST(StudioWorld, UndoingAChangedParameterPutsItBackAndGoesOn) {
  World world(small_flock(), plenty);
  const std::string path = "flock." + flock_of(world) + ".max_speed";
  const std::string old = *sturnus::get_parameter(world.simulation().scenario(), path);
  ASSERT_TRUE(world.act(SetParameter{path, "20"}, "max_speed", 7));
  ASSERT_TRUE(world.act(SetParameter{path, "25"}, "max_speed", 7));
  run(world, 3);
  ASSERT_TRUE(world.undo());
  EXPECT_EQ(*sturnus::get_parameter(world.simulation().scenario(), path), old);
  EXPECT_EQ(world.simulation().step_number(), 3u);
  ASSERT_TRUE(world.redo());
  EXPECT_EQ(*sturnus::get_parameter(world.simulation().scenario(), path), "25");
  EXPECT_FALSE(world.redo());
}

TEST(StudioWorld, ScrubbingFindsTheSameBitsWithCommandsDoneAgain) {
  World world(small_flock(), plenty);
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < 60; ++i) {
    hashes.push_back(world.simulation().hash());
    if (i == 30) {
      ASSERT_TRUE(world.act(EraseBoids{{0, 0}, 30}, "erase"));
      hashes.back() = world.simulation().hash();
    }
    world.step();
  }
  for (const std::uint64_t step : {59u, 3u, 30u, 31u, 0u, 47u, 46u}) {
    go(world, step);
    EXPECT_EQ(world.simulation().step_number(), step);
    EXPECT_EQ(world.simulation().hash(), hashes[step]) << step;
  }
  EXPECT_EQ(world.last(), 60u);
  go(world, 500);
  EXPECT_EQ(world.simulation().step_number(), 60u);
}

TEST(StudioWorld, ActingInThePastBeginsAnotherFuture) {
  World world(small_flock(), plenty);
  run(world, 40);
  go(world, 20);
  ASSERT_TRUE(world.act(EraseBoids{{0, 0}, 30}, "erase"));
  EXPECT_EQ(world.last(), 20u);
  run(world, 10);
  ASSERT_TRUE(world.undo());
  EXPECT_EQ(world.simulation().step_number(), 20u);
  EXPECT_EQ(world.last(), 40u) << "the future that there was is lost";
}

// Adds, sets a parameter, erases; and what the world was at every step.
struct Told {
  World world{small_flock(), plenty};
  std::vector<std::uint64_t> hashes;

  Told() {
    const std::map<int, sturnus::Command> deeds = {
        {10, AddBoids{flock_of(world), 8, {0, 0}, 5}},
        {20, SetParameter{"flock." + flock_of(world) + ".max_speed", "20"}},
        {30, EraseBoids{{0, 0}, 60}}};
    for (int i = 0; i < 50; ++i) {
      if (const auto deed = deeds.find(i); deed != deeds.end()) {
        EXPECT_TRUE(world.act(deed->second, "deed"));
      }
      hashes.push_back(world.simulation().hash());
      world.step();
    }
    hashes.push_back(world.simulation().hash());
  }
  void expect_all() {
    EXPECT_EQ(world.last(), 50u);
    for (const std::uint64_t step : {50u, 5u, 35u, 12u, 25u, 30u}) {
      go(world, step);
      EXPECT_EQ(world.simulation().hash(), hashes[step]) << step;
    }
  }
};

TEST(StudioWorld, UndoInThePastTakesTheLastDeedBackWhereItWasDoneAndRedoBringsAllOfItAgain) {
  Told told;
  World& world = told.world;
  go(world, 15);
  ASSERT_TRUE(world.undo());  // the eraser's stroke, which lies ahead
  EXPECT_EQ(world.simulation().step_number(), 30u);
  EXPECT_EQ(world.last(), 30u);
  EXPECT_EQ(world.simulation().view().size(), 208u);
  go(world, 15);
  ASSERT_TRUE(world.undo());  // the value, which was set ahead
  EXPECT_EQ(world.simulation().step_number(), 20u);
  EXPECT_NE(world.simulation().scenario().flocks[0].max_speed, 20);
  ASSERT_TRUE(world.undo());
  EXPECT_EQ(world.simulation().step_number(), 10u);
  EXPECT_EQ(world.simulation().view().size(), 200u);
  EXPECT_FALSE(world.undo());
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(world.redo());
  EXPECT_EQ(world.simulation().step_number(), 15u);
  told.expect_all();
}

TEST(StudioWorld, UndoOfADeedOfThePastBringsTheOldFutureBack) {
  Told told;
  World& world = told.world;
  const std::string path = "flock." + flock_of(world) + ".min_speed";
  const std::string old = *sturnus::get_parameter(world.simulation().scenario(), path);
  for (const sturnus::Command& command :
       {sturnus::Command(EraseBoids{{0, 0}, 90}), sturnus::Command(SetParameter{path, "0.25"})}) {
    go(world, 25);
    ASSERT_TRUE(world.act(command, "branch"));
    run(world, 40);
    EXPECT_EQ(world.last(), 65u);
    go(world, 40);
    ASSERT_TRUE(world.undo());
    EXPECT_EQ(world.simulation().step_number(), 25u);
    EXPECT_EQ(*sturnus::get_parameter(world.simulation().scenario(), path), old);
    told.expect_all();
  }
  go(world, 40);
  ASSERT_TRUE(world.redo());
  EXPECT_EQ(world.last(), 65u);
  ASSERT_TRUE(world.undo());
  ASSERT_TRUE(world.undo());
  EXPECT_EQ(world.simulation().step_number(), 30u) << "the deeds before it are still there to be undone";
}

TEST(StudioWorld, RedoLeadsToItsOwnPastToo) {
  World world(small_flock(), plenty);
  run(world, 10);
  ASSERT_TRUE(world.act(EraseBoids{{0, 0}, 60}, "erase"));
  run(world, 10);
  const std::uint64_t at_20 = world.simulation().hash();
  go(world, 17);
  const std::uint64_t at_17 = world.simulation().hash();
  go(world, 20);
  ASSERT_TRUE(world.undo());
  run(world, 10);  // keeps moments without the stroke
  ASSERT_TRUE(world.redo());
  EXPECT_EQ(world.simulation().hash(), at_20);
  go(world, 17);
  EXPECT_EQ(world.simulation().hash(), at_17);
}

TEST(StudioWorld, ADeedOfTheFirstStepIsThereAfterRedoAndGoneAfterUndo) {
  World world(small_flock(), plenty);
  const std::uint64_t untouched = world.simulation().hash();
  ASSERT_TRUE(world.act(AddBoids{flock_of(world), 8, {0, 0}, 5}, "add"));
  const std::uint64_t added = world.simulation().hash();
  run(world, 20);
  ASSERT_TRUE(world.undo());
  EXPECT_EQ(world.simulation().hash(), untouched);
  run(world, 10);
  ASSERT_TRUE(world.redo());
  go(world, 0);
  EXPECT_EQ(world.simulation().hash(), added);
  ASSERT_TRUE(world.undo());
  run(world, 10);
  go(world, 0);
  EXPECT_EQ(world.simulation().hash(), untouched);
}

TEST(StudioWorld, AHandOfThePastLetsGoWhereAnotherFutureBegins) {
  World world(small_flock(), plenty);
  ASSERT_TRUE(world.act(sturnus::MovePointer{sturnus::PointerMode::attract, {0, 0}, true}, "drag", 1));
  run(world, 20);
  ASSERT_TRUE(world.act(sturnus::MovePointer{sturnus::PointerMode::attract, {0, 0}, false}, ""));
  run(world, 20);
  go(world, 10);
  ASSERT_TRUE(world.simulation().view().state().pointer.pressed);
  ASSERT_TRUE(world.act(EraseBoids{{0, 0}, 30}, "erase"));
  EXPECT_FALSE(world.simulation().view().state().pointer.pressed);
  run(world, 10);
  auto replay = sturnus::open_simulation(world.simulation().recording(), 1);
  ASSERT_TRUE(replay) << replay.error();
  replay->run(20);
  EXPECT_EQ(replay->hash(), world.simulation().hash());
}

TEST(StudioWorld, AScenariosOwnPointerHoldsOnWhereAnotherFutureBegins) {
  auto scenario = sturnus::load_scenario("ucsd");
  scenario->run.events = {{5, sturnus::MovePointer{sturnus::PointerMode::attract, {400, 300}, true}}};
  World world(std::move(*sturnus::open_simulation(*scenario, 1)), plenty);
  run(world, 20);
  go(world, 10);
  ASSERT_TRUE(world.act(EraseBoids{{0, 0}, 30}, "erase"));
  EXPECT_TRUE(world.simulation().view().state().pointer.pressed);
}

TEST(StudioWorld, TheHistoryKeepsToItsBudgetAndStillReachesTheStart) {
  World world(small_flock(), 300'000);
  const std::uint64_t start = world.simulation().hash();
  run(world, 600);
  EXPECT_LE(world.history().bytes(), 300'000u);
  EXPECT_GT(world.history().size(), 5u);
  go(world, 0);
  EXPECT_EQ(world.simulation().hash(), start);
}

TEST(StudioWorld, ItsRecordingReplaysToTheSameHash) {
  World world(small_flock(), plenty);
  run(world, 5);
  ASSERT_TRUE(world.act(AddBoids{flock_of(world), 16, {10, 0}, 8}, "add"));
  run(world, 5);
  ASSERT_TRUE(world.act(EraseBoids{{0, 0}, 20}, "erase"));
  run(world, 5);
  ASSERT_TRUE(world.undo());
  ASSERT_TRUE(world.act(sturnus::ScatterBoids{{0, 0}, 50}, "scatter"));
  run(world, 20);
  auto replay = sturnus::open_simulation(world.simulation().recording(), 1);
  ASSERT_TRUE(replay) << replay.error();
  replay->run(world.simulation().step_number());
  EXPECT_EQ(replay->hash(), world.simulation().hash());
}

TEST(StudioWorld, AnotherWorldCanBeUndone) {
  World world(small_flock(), plenty);
  run(world, 12);
  const std::uint64_t before = world.simulation().hash();
  world.replace(small_flock(50), "open");
  EXPECT_EQ(world.simulation().view().size(), 50u);
  ASSERT_TRUE(world.undo());
  EXPECT_EQ(world.simulation().hash(), before);
  ASSERT_TRUE(world.redo());
  EXPECT_EQ(world.simulation().view().size(), 50u);
}

TEST(StudioWorld, WhatWasDoneBeforeARestartCanStillBeUndoneWithItsPast) {
  Told told;
  World& world = told.world;
  for (const std::int64_t seed : {7, 8}) {
    ASSERT_TRUE(world.restart(seed));
    EXPECT_EQ(world.simulation().step_number(), 0u);
    EXPECT_EQ(world.simulation().scenario().seed, seed);
    run(world, 15);
    ASSERT_TRUE(world.act(EraseBoids{{0, 0}, 30}, "erase"));
  }
  world.replace(small_flock(20), "open");
  run(world, 5);
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(world.undo());
  told.expect_all();
  ASSERT_TRUE(world.undo());
  EXPECT_EQ(world.simulation().step_number(), 30u);
  EXPECT_EQ(world.simulation().view().size(), 208u);
  for (int i = 0; i < 6; ++i) ASSERT_TRUE(world.redo());
  EXPECT_EQ(world.simulation().view().size(), 20u);
  EXPECT_EQ(world.last(), 5u);
}

TEST(StudioWorld, UndoKeepsWithinItsMemory) {
  World world(small_flock(), 400'000);
  for (int i = 0; i < 40; ++i) {
    run(world, 20);
    ASSERT_TRUE(world.restart(i));
    ASSERT_TRUE(world.act(EraseBoids{{0, 0}, 30}, "erase"));
  }
  int undone = 0;
  while (world.undo()) ++undone;
  EXPECT_GT(undone, 1);
  EXPECT_LT(undone, 40);
}

TEST(StudioWorld, StartingAgainAfterAnUndoneOpenPlaysItsOwnEvents) {
  const auto flock_with = [](std::vector<sturnus::Event> events) {
    auto scenario = sturnus::load_scenario("ucsd");
    scenario->run.events = std::move(events);
    return std::move(*sturnus::open_simulation(*scenario, 1));
  };
  const auto own = [&] { return flock_with({{5, EraseBoids{{0, 0}, 300}}}); };
  World world(own(), plenty);
  run(world, 3);
  world.replace(flock_with({{4, AddBoids{"birds", 50, {100, 100}, 20}}}), "open");
  run(world, 3);
  ASSERT_TRUE(world.undo());
  ASSERT_TRUE(world.restart(world.simulation().scenario().seed));
  run(world, 20);
  World untouched(own(), plenty);
  run(untouched, 20);
  EXPECT_EQ(world.simulation().hash(), untouched.simulation().hash());
}

TEST(StudioWorld, TrackingGoesRoundAndOnWhenTheBoidIsGone) {
  World world(small_flock(5), plenty);
  Frame frame;
  world.track(4);
  world.track_next(1);
  world.show(frame);
  ASSERT_TRUE(frame.tracked && frame.explained);
  EXPECT_EQ(frame.ids[*frame.tracked], 0u);
  world.track_next(-1);
  world.show(frame);
  EXPECT_EQ(frame.explained->id, 4u);
  ASSERT_TRUE(world.act(EraseBoids{{0, 0}, 1e6}, "erase"));
  world.show(frame);
  EXPECT_FALSE(frame.tracked);
}

TEST(StudioSession, ServesInOrderAndShowsWhatWasOrdered) {
  Session session(small_flock(), {plenty, true});
  const auto first = session.frame();
  session.act(AddBoids{first->scenario->flocks[0].name, 4, {0, 0}, 1}, "add");
  session.run_to(10, first->generation);
  session.settle();
  const auto tenth = session.frame();
  EXPECT_EQ(tenth->step, 10u);
  EXPECT_EQ(tenth->boids.size(), 204u);
  EXPECT_EQ(tenth->reach.undo, "add");
  session.go_to(3);
  session.settle();
  EXPECT_EQ(session.frame()->step, 3u);
  session.run_to(500, first->generation);  // of a generation that is gone
  session.settle();
  EXPECT_EQ(session.frame()->step, 3u);
  EXPECT_EQ(session.take_samples().size(), 2u);
}

TEST(StudioSession, WhatCantBeDoneIsToldAndChangesNothing) {
  Session session(small_flock(), {plenty, true});
  session.act(SetParameter{"flock.nobody.max_speed", "3"}, "max_speed");
  session.settle();
  const auto notes = session.take_notes();
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_TRUE(notes[0].is_problem);
  EXPECT_NE(notes[0].text.find("nobody"), std::string::npos) << notes[0].text;
  EXPECT_TRUE(session.frame()->reach.undo.empty());
}

TEST(StudioPlayback, StepsAreDueByTimeAndShownInBetween) {
  Session session(small_flock(), {plenty, true});
  Playback playback;
  const auto tick = [&](double seconds) {
    playback.advance(seconds, *session.frame(), session);
    session.settle();
    return session.frame();
  };
  auto frame = tick(1.0 / 60);
  EXPECT_EQ(frame->step, 1u);
  EXPECT_FLOAT_EQ(playback.part(*frame), 0.5f);
  for (int i = 0; i < 59; ++i) frame = tick(1.0 / 60);
  EXPECT_EQ(frame->step, 30u);
  playback.play(false);
  frame = tick(1);
  EXPECT_EQ(frame->step, 30u);
  playback.step_once();
  EXPECT_EQ(tick(1.0 / 60)->step, 31u);
  EXPECT_EQ(tick(1.0 / 60)->step, 31u);
  playback.play(true);
  playback.set_speed(1000);
  EXPECT_EQ(playback.speed(), 100);
  EXPECT_EQ(tick(1.0 / 60)->step, 81u);
}

}  // namespace
}  // namespace studio
