// Hunters and food as files state them: what is wrong is said, and what is right comes back from the printer.
#include <gtest/gtest.h>

#include "support.h"

namespace sturnus::test {
namespace {

std::string sea(const std::string& sharks, const std::string& more = "") {
  return "[[flock]]\nname = \"fish\"\nmax_speed = 4\nbody_radius = 1\n[[flock]]\nname = "
         "\"sharks\"\nmax_speed = 9\n" +
         sharks + "\n" + more;
}

/// All sentences about a file, warnings too.
std::string told(const std::string& text) {
  Problems problems;
  const bool is_taken = static_cast<bool>(parse_scenario(text, "sea.toml", &problems));
  EXPECT_EQ(is_taken, !has_errors(problems));
  std::string out;
  for (const Problem& problem : problems) out += problem.key + ": " + problem.text + "\n";
  return out;
}

TEST(Creatures, WhatIsWrongIsSaid) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {sea("hunt = { prey = [\"fihs\"] }"), "there is no flock \"fihs\"; did you mean \"fish\"?"},
      {sea("hunt = { prey = [] }"), "names nobody to hunt"},
      {sea("hunt = { prey = [\"sharks\"] }"), "a flock can't hunt itself"},
      {sea("jump = { speed = 9 }"), "flock.sharks.jump: a jump is at prey: it needs a hunt"},
      {sea("hunger = { full_for = 9 }"), "flock.sharks.hunger: only who hunts can be hungry"},
      {sea("max_acceleration = 1\nhunt = { prey = [\"fish\"], confusion = 1 }"), "only choose = \"nearest\""},
      {sea("feed = { on = \"krill\" }"), "there is no food \"krill\"; a file needs a [[food]]"},
      {sea("feed = { on = \"kril\" }", "[[food]]\nname = \"krill\""), "did you mean \"krill\"?"},
      {sea("feed = { on = \"krill\", form = \"arrive\" }", "[[food]]\nname = \"krill\""),
       "nobody slows down for food"},
      {sea("", "[[food]]\nname = \"a b\""), "must be letters, digits, - and _"},
      {sea("", "[[food]]\nname = \"a\"\n[[food]]\nname = \"a\""), "two kinds of food are called \"a\""},
      {sea("", "[[food]]\nat = [1, 2, 3]"), "must have 2 numbers, but has 3"},
      {sea("", "[[food]]\ncolour = \"green\""), "must be \"#rrggbb\""},
      {sea("", "[[food]]\nrandom = { evry = 3 }"), "did you mean \"every\"?"},
      {sea("hunt = { prey = [\"fish\"] }\nbody_radius = 1",
           "[run]\nevents = [[3, \"food\", \"krill\", 3, [0, 0]]]"),
       "there is no food \"krill\""},
  };
  for (const auto& [text, wanted] : cases) {
    EXPECT_NE(told(text).find(wanted), std::string::npos) << text << "\n-> " << told(text);
  }
}

TEST(Creatures, AHunterThatCannotOutrunItsPreyIsWarnedOf) {
  EXPECT_EQ(told(sea("hunt = { prey = [\"fish\"] }")), "");
  const std::string slow =
      "[[flock]]\nname = \"fish\"\nmax_speed = 9\nbody_radius = 1\n[[flock]]\nname = \"sharks\"\nmax_speed = "
      "9\n"
      "hunt = { prey = [\"fish\"] }\n";
  EXPECT_NE(told(slow).find("can't outrun its prey \"fish\": 9 is not above 9"), std::string::npos)
      << told(slow);
  EXPECT_NE(told(slow + "jump = { speed = 8 }").find("even in a jump: 9 is not above 9"), std::string::npos);
  EXPECT_EQ(told(slow + "jump = { speed = 10 }"), "");
  EXPECT_NE(told(slow + "jump = { speed = 10, on = false }").find("can't outrun"), std::string::npos);
}

TEST(Creatures, ComeBackFromThePrinter) {
  for (const ShippedScenario& shipped : shipped_scenarios()) {
    const ScenarioDef scenario = take(parse_scenario(shipped.text, shipped.name));
    const ScenarioDef again = take(parse_scenario(to_toml(scenario), shipped.name));
    EXPECT_EQ(to_toml(again), to_toml(scenario)) << shipped.name;
    ASSERT_EQ(again.food.size(), scenario.food.size());
  }
}

TEST(Creatures, EventsOfFoodComeBackFromThePrinter) {
  ScenarioDef scenario = take(parse_scenario(
      sea("", "[[food]]\nname = \"krill\"\n[run]\nevents = [[3, \"food\", \"krill\", 7, [1, 2], 5]]"),
      "sea"));
  scenario = take(parse_scenario(to_toml(scenario), "sea"));
  const auto& add = std::get<AddFood>(scenario.run.events.at(0).command);
  EXPECT_EQ(add.food, "krill");
  EXPECT_EQ(add.count, 7);
  EXPECT_EQ(add.at, (Coordinates{1, 2}));
  EXPECT_EQ(add.radius, 5);
}

}  // namespace
}  // namespace sturnus::test
