// Predators and food in worlds that have none: they come, are undone, and the session replays to the bit.
#include "session/creatures.h"

#include "session/world.h"
#include "studio_support.h"
#include "ui.h"

namespace studio::test {
namespace {

TEST(StudioCreatures, WhoHuntsOrIsFledFromIsAPredator) {
  const auto count = [](const char* name) { return flocks_that(*sturnus::load_scenario(name), true); };
  EXPECT_EQ(count("ucsd-predator"), std::vector<std::size_t>{1});
  EXPECT_EQ(count("sharks-and-fish"), std::vector<std::size_t>{1});
  EXPECT_TRUE(count("ucsd").empty());
}

TEST(StudioCreatures, EveryShippedScenarioCanBeGivenPredatorsAndFood) {
  for (const sturnus::ShippedScenario& one : sturnus::shipped_scenarios()) {
    sturnus::ScenarioDef scenario = *sturnus::load_scenario(one.name);
    give_predators(scenario);
    give_food(scenario);
    for (const sturnus::Problem& problem : check(scenario))
      EXPECT_TRUE(problem.is_warning) << one.name << ": " << problem.sentence();
    EXPECT_TRUE(is_predator(scenario, scenario.flocks.size() - 1));
    const auto again = sturnus::parse_scenario(to_toml(scenario), "again");
    ASSERT_TRUE(again) << one.name << ": " << again.error();
  }
}

class StudioCreatureTools : public Ui {
 protected:
  static constexpr float x = 560, y = 330;

  // What `sturnus run` says of the saved session.
  void expect_replay() {
    pause();
    const std::uint64_t end = hash(), step = world().step;
    std::filesystem::remove("visit.toml");
    std::filesystem::remove("visit-start.csv");
    desk().files.save_session(desk(), "visit");
    frames(2);
    const auto saved = sturnus::load_scenario("visit.toml");
    ASSERT_TRUE(saved) << saved.error();
    auto replay = sturnus::open_simulation(*saved, 1);
    ASSERT_TRUE(replay) << replay.error();
    replay->run(step - replay->step_number());
    EXPECT_EQ(replay->hash(), end);
#ifdef STURNUS_PROGRAM
    char expected[32];
    std::snprintf(expected, sizeof expected, "%016llx", static_cast<unsigned long long>(end));
    EXPECT_SAYS(output_of(STURNUS_PROGRAM " run visit.toml 2>&1"), expected);
#endif
  }
};

TEST_F(StudioCreatureTools, APredatorComesWhereThereWereNone) {
  for (const char* name : {"ucsd", "murmuration"}) {
    open(name);
    frames(30);
    pause();
    const std::uint64_t before = hash(), step = world().step;
    const std::vector<std::uint64_t> ids = world().ids;
    key(SDLK_8);
    click(x, y);
    ASSERT_EQ(world().scenario->flocks.size(), 2u);
    EXPECT_EQ(world().step, step);
    EXPECT_EQ(world().population[1], 1u);
    EXPECT_EQ(world().boids.size(), ids.size() + 1);
    EXPECT_TRUE((world().boids.back().flags & is_hunter) != 0);
    EXPECT_EQ(world().scenario->flocks[0].flee.size(), 1u);
    key(SDLK_z, KMOD_CTRL);
    EXPECT_EQ(hash(), before);
    EXPECT_EQ(world().scenario->flocks.size(), 1u);
    key(SDLK_z, KMOD_CTRL | KMOD_SHIFT);
    EXPECT_EQ(world().population[1], 1u);
    click(x + 60, y);
    EXPECT_EQ(world().population[1], 2u);
    EXPECT_EQ(world().scenario->flocks.size(), 2u) << "another flock for the second one";
    desk().playback.play(true);
    frames(60);
    expect_replay();
    studio_.reset();
  }
}

TEST_F(StudioCreatureTools, FoodComesWhereThereWasNoneAndIsEaten) {
  open("ucsd");
  frames(10);
  pause();
  key(SDLK_7);
  click(x, y);
  ASSERT_EQ(world().food.size(), 1u);
  EXPECT_TRUE(world().scenario->flocks[0].feed);
  click(x + 50, y);
  EXPECT_EQ(world().food.size(), 2u);
  desk().playback.play(true);
  for (int i = 0; i < 900 && world().boids.size() == 200; ++i) frames();
  EXPECT_GT(world().boids.size(), 200u) << "nobody ate it";
  expect_replay();
}

TEST_F(StudioCreatureTools, FoodComesToAWorldFromWhichEverybodyIsGone) {
  open("ucsd");
  pause();
  desk().session.act(sturnus::EraseBoids{{0, 0}, 1e5}, "eraser");
  frames(2);
  ASSERT_TRUE(world().boids.empty());
  key(SDLK_7);
  click(x, y);
  ASSERT_EQ(world().food.size(), 1u);
  key(SDLK_1);
  click(x, y);
  EXPECT_EQ(world().boids.size(), 8u);
  expect_replay();
}

TEST_F(StudioCreatureTools, WhatWasGivenStaysInTheScenario) {
  open("ucsd");
  frames(10);
  key(SDLK_8);
  click(x, y);
  press("top.restart");
  frames(2);
  EXPECT_LT(world().step, 5u);
  ASSERT_EQ(world().scenario->flocks.size(), 2u);
  EXPECT_EQ(world().population[1], 1u);
  key(SDLK_c, KMOD_CTRL);
  key(SDLK_v, KMOD_CTRL);
  ASSERT_EQ(world().scenario->flocks.size(), 2u);
  EXPECT_EQ(world().population[1], 1u);
}

TEST_F(StudioCreatureTools, APredatorThatDoesNotHuntIsOneTooAndToolsKnowItsFlock) {
  open("ucsd-predator");
  pause();
  key(SDLK_8);
  click(x, y);
  EXPECT_EQ(world().scenario->flocks.size(), 2u);
  EXPECT_EQ(world().population[1], 2u);
  key(SDLK_1);
  click(x, y);
  EXPECT_EQ(world().population[0], 208u);
}

TEST_F(StudioCreatureTools, UnitsGoToTheFlockThatIsChosen) {
  open("two-flocks");
  pause();
  key(SDLK_1);
  click(x, y);
  EXPECT_EQ(world().population[0], 208u);
  const std::size_t other = world().population[1];
  press("tool.flock");
  click(x, y);
  EXPECT_EQ(world().population[1], other + 8);
  press("tool.flock");
  click(x, y);
  EXPECT_EQ(world().population[0], 216u);
}

}  // namespace
}  // namespace studio::test
