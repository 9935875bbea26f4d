// What pictures show of hunters and food: red when full, paler as they starve, a tail that tells of the jump.
#include <gtest/gtest.h>

#include "observe/scene.h"
#include "support.h"

namespace sturnus::test {
namespace {

SceneColours colours() {
  SceneColours out;
  out.flocks.fill(rgb(0x000000));
  out.food = rgb(0x00ff01);
  out.full = rgb(0xff0000);
  out.starved = rgb(0xc8c8c8);
  out.ready = rgb(0x00ff00);
  out.tired = rgb(0x777777);
  return out;
}

ScenarioDef one_hunter() {
  ScenarioDef scenario = bare();
  scenario.flocks.push_back(scenario.flocks.front());
  scenario.flocks[0].name = "hunters";
  scenario.flocks[1].name = "prey";
  scenario.flocks[0].colour.start = "#000000";
  scenario.flocks[0].max_speed = 5;
  scenario.flocks[0].hunt = Hunt{.prey = {"prey"}};
  scenario.flocks[0].hunger = Hunger{.full_for = 10, .starves_after = 100};
  scenario.flocks[0].jump = Jump{};
  scenario.food.push_back(FoodDef{});
  return scenario;
}

DrawList scene_of(double full, double fasting, double jump, double rest) {
  State state = state_of(2, {{{0, 0}, {2, 0}, 0}});
  state.life = {{full}, {fasting}, {jump}, {rest}, {}};
  state.food = {{7}, {0}, {{{50}, {60}, {}}}};
  state.next_id = 8;
  const Simulation world = world_from(one_hunter(), state);
  DrawList list;
  make_scene(world.view(), colours(), {}, list);
  return list;
}

TEST(CreatureScene, FoodLiesBelowTheHunterAndTheTailAbove) {
  const DrawList list = scene_of(0, 0, 0, 0);
  ASSERT_EQ(list.glyphs.size(), 3u);
  EXPECT_EQ(list.glyphs[0].colour, rgb(0x00ff01));
  EXPECT_EQ(list.glyphs[0].position[1], 60);
  EXPECT_EQ(list.glyphs[1].colour, rgb(0x000000));
  EXPECT_EQ(list.glyphs[2].colour, rgb(0x00ff00)) << "ready";
  EXPECT_LT(list.glyphs[2].position[0], 0) << "behind";
}

TEST(CreatureScene, ColoursFollowTheClocks) {
  EXPECT_EQ(scene_of(3, 0, 0, 0).glyphs[1].colour, rgb(0xff0000));
  EXPECT_EQ(scene_of(0, 50, 0, 0).glyphs[1].colour, rgb(0x646464));
  EXPECT_EQ(scene_of(0, 100, 0, 0).glyphs[1].colour, rgb(0xc8c8c8));
  EXPECT_EQ(scene_of(0, 0, 5, 0).glyphs[2].colour, rgb(0x777777));
  EXPECT_EQ(scene_of(0, 0, 0, 5).glyphs[2].colour, rgb(0x777777));
}

}  // namespace
}  // namespace sturnus::test
