// Clocks, focus and food in the state CSV: there and back, and what is wrong with a line of food.
#include <gtest/gtest.h>

#include <sturnus/files.h>

#include "support.h"
#include "world/state.h"

namespace sturnus::test {
namespace {

State hunter_and_food() {
  State state = state_of(2, {{{1, 2}, {3, 4}, 0}, {{5, 6}, {7, 8}, 1}});
  state.life = {{0, 1.0 / 3}, {12.5, 0.1}, {0, 7}, {3, 0}, {nobody, 0}};
  state.food = {{11, 12}, {0, 2}, {{{0.1f, 9}, {-4, 5}, {}}}};
  state.next_id = 13;
  return state;
}

TEST(CreatureCsv, ComesBackBitForBit) {
  for (const std::uint64_t next_id : {13u, 40u}) {
    State state = hunter_and_food();
    state.next_id = next_id;
    const State again = take(parse_state_csv(state_csv(state), "saved"));
    EXPECT_EQ(hash(again), hash(state)) << state_csv(state);
    EXPECT_EQ(again.life.full[1], 1.0 / 3);
    EXPECT_EQ(again.life.focus[0], nobody);
    EXPECT_EQ(again.next_id, next_id);
  }
}

TEST(CreatureCsv, ReadsAsItIsWritten) {
  EXPECT_EQ(state_csv(hunter_and_food()),
            "id,flock,x,y,vx,vy,full,fasting,jump,rest,focus,food\n"
            "0,0,1,2,3,4,0,12.5,0,3,,\n"
            "1,1,5,6,7,8,0.3333333333333333,0.1,7,0,0,\n"
            "11,,0.1,-4,,,,,,,,0\n"
            "12,,9,5,,,,,,,,2\n");
}

TEST(CreatureCsv, FoodAloneIsAState) {
  State state;
  state.food = {{3}, {0}, {{{1}, {2}, {}}}};
  state.next_id = 4;
  const State again = take(parse_state_csv(state_csv(state), "saved"));
  EXPECT_EQ(again.size(), 0u);
  EXPECT_EQ(hash(again), hash(state));
}

TEST(CreatureCsv, WhatIsWrongIsSaidWithItsLine) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"id,x,y,food\n0,1,2,\n1,1,2,no", "food: must be a whole number"},
      {"id,x,y,food\n0,1,2,\n0,1,2,0", "two boids have the id 0"},
      {"x,y,food\n1,2,0", "pieces of food need the column id"},
      {"id,x,y,vx,vy,food\n1,1,2,3,3,0", "vx: must be empty for a piece of food, but found \"3\""},
      {"id,x,y,full\n1,1,2,-3", "full: must be a time from 0 to 1e15, but found \"-3\""},
      {"id,x,y,food,food\n1,1,2,0,0", "the column stands there twice"},
  };
  for (const auto& [text, wanted] : cases) {
    const auto state = parse_state_csv(text, "saved.csv");
    ASSERT_FALSE(state) << text;
    EXPECT_NE(state.error().find(wanted), std::string::npos) << state.error();
  }
}

TEST(CreatureCsv, FoodOfAKindThatTheScenarioLacksIsRefused) {
  ScenarioDef scenario = bare();
  scenario.flocks.push_back(scenario.flocks.front());
  scenario.flocks[1].name = "others";
  scenario.run.initial = "saved";
  SimulationOptions options;
  options.tables["saved"] = hunter_and_food();
  const auto refused = Simulation::create(scenario, options);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().find("holds food of kind 0, but there are only 0 kinds of food"),
            std::string::npos)
      << refused.error();
}

}  // namespace
}  // namespace sturnus::test
