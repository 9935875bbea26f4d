// Files and the clipboard: what changes on disk changes the world, and nothing is lost on bad input.
#include "files/files.h"

#include <sturnus/parameters.h>

#include "files/recent.h"
#include "studio_support.h"

namespace studio {
namespace {

constexpr int until_looked = 40;  // frames; the file is looked at twice a second

constexpr const char* small_world = R"(format = 1
[space]
dimensions = 2
min = [0, 0]
max = [400, 300]
[[flock]]
name = "birds"
count = 40
min_speed = 1
max_speed = 2
cohesion = { weight = 0.01, radius = 50 }
)";

std::string with(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, from.size(), to);
}

class StudioFiles : public StudioTest {
 protected:
  void open_world() {
    write("world.toml", small_world);
    open("world.toml", 0);
  }
};

TEST_F(StudioFiles, AGoodChangeOfTheFileIsSetWhileTheWorldGoesOn) {
  open_world();
  frames(60);
  const std::uint64_t step = desk().frame->step, generation = desk().frame->generation;
  write("world.toml", with(small_world, "weight = 0.01", "weight = 0.5"));
  frames(until_looked);
  EXPECT_EQ(scenario().flocks[0].cohesion[0].weight, 0.5);
  EXPECT_GT(desk().frame->step, step);
  EXPECT_EQ(desk().frame->generation, generation) << "the world began anew";
  press(SDLK_z, KMOD_LCTRL);
  EXPECT_EQ(scenario().flocks[0].cohesion[0].weight, 0.01);
}

TEST_F(StudioFiles, ABadFileIsExplainedAndTheOldWorldRunsOn) {
  open_world();
  frames(20);
  const std::uint64_t step = desk().frame->step;
  write("world.toml", with(small_world, "weight = 0.01", "wieght = 0.5"));
  frames(until_looked);
  EXPECT_SAYS(said(), "world.toml:11: ");
  EXPECT_SAYS(said(), "wieght");
  EXPECT_GT(desk().frame->step, step);
  EXPECT_EQ(scenario().flocks[0].cohesion[0].weight, 0.01);
  write("world.toml", with(small_world, "weight = 0.01", "weight = 0.75"));
  frames(until_looked);
  EXPECT_EQ(scenario().flocks[0].cohesion[0].weight, 0.75);
}

TEST_F(StudioFiles, ABrokenFileIsToldUntilItIsRightOrDismissed) {
  open_world();
  write("world.toml", with(small_world, "weight = 0.01", "wieght = 0.5"));
  frames(until_looked + 15 * 60);
  EXPECT_SAYS(said(), "world.toml:11: ");
  write("world.toml", with(small_world, "weight = 0.01", "weihgt = 0.5"));
  frames(until_looked);
  EXPECT_SAYS(said(), "weihgt");
  EXPECT_EQ(said().find("wieght"), std::string::npos) << "what is no longer so is still said";
  ASSERT_TRUE(desk().items.contains("note.dismiss"));
  click("note.dismiss");
  EXPECT_EQ(said(), "");
  write("world.toml", with(small_world, "weight = 0.01", "wiehgt = 0.5"));
  frames(until_looked);
  EXPECT_SAYS(said(), "wiehgt");
  write("world.toml", with(small_world, "weight = 0.01", "weight = 0.75"));
  frames(until_looked);
  EXPECT_EQ(said().find("wiehgt"), std::string::npos);
  EXPECT_EQ(scenario().flocks[0].cohesion[0].weight, 0.75);
}

TEST_F(StudioFiles, ABrokenFileOfAnotherWorldIsNoLongerTold) {
  open_world();
  write("world.toml", with(small_world, "weight = 0.01", "wieght = 0.5"));
  frames(until_looked);
  ASSERT_NE(said().find("wieght"), std::string::npos);
  write("other.toml", small_world);
  drop(path("other.toml"));
  EXPECT_EQ(said().find("wieght"), std::string::npos);
}

TEST_F(StudioFiles, ManyChangesOfAFileAreOneDeed) {
  open_world();
  const std::string before = to_toml(scenario());
  write("world.toml",
        with(with(small_world, "weight = 0.01", "weight = 0.5"), "max_speed = 2", "max_speed = 3"));
  frames(until_looked);
  ASSERT_EQ(scenario().flocks[0].max_speed, 3);
  ASSERT_EQ(scenario().flocks[0].cohesion[0].weight, 0.5);
  press(SDLK_z, KMOD_LCTRL);
  EXPECT_EQ(to_toml(scenario()), before);
  press(SDLK_y, KMOD_LCTRL);
  EXPECT_EQ(scenario().flocks[0].max_speed, 3);
}

TEST_F(StudioFiles, ABrokenScenarioThatIsDroppedIsExplainedAndTheWorldFliesOn) {
  open_world();
  write("bad.toml", with(small_world, "count = 40", "count = many"));
  const std::uint64_t step = desk().frame->step, generation = desk().frame->generation;
  drop(path("bad.toml"));
  frames(10);
  EXPECT_SAYS(said(), "bad.toml:8");
  EXPECT_GT(desk().frame->step, step);
  EXPECT_EQ(desk().frame->generation, generation);
  EXPECT_EQ(desk().frame->boids.size(), 40u);
  EXPECT_EQ(desk().files.watched(), "world.toml");
}

TEST_F(StudioFiles, WhatCantBeSetBeginsTheWorldAnewAndUndoBringsTheOldOneBack) {
  open_world();
  frames(60);
  desk().playback.play(false);
  frames(5);
  const std::uint64_t step = desk().frame->step, before = hash();
  write("world.toml", with(small_world, "count = 40", "count = 70"));
  frames(until_looked);
  EXPECT_EQ(desk().frame->boids.size(), 70u);
  EXPECT_SAYS(said(), "began anew");
  press(SDLK_z, KMOD_LCTRL);
  EXPECT_EQ(desk().frame->boids.size(), 40u);
  EXPECT_EQ(desk().frame->step, step);
  EXPECT_EQ(hash(), before);
  frames(until_looked);
  EXPECT_EQ(hash(), before) << "the file undid the undo";
}

TEST_F(StudioFiles, UndoOfOpenWatchesTheFileBeforeAgain) {
  open_world();
  write("other.toml", with(small_world, "count = 40", "count = 25"));
  drop(path("other.toml"));
  ASSERT_EQ(desk().frame->boids.size(), 25u);
  EXPECT_EQ(desk().files.watched(), path("other.toml"));
  press(SDLK_z, KMOD_LCTRL);
  frames(until_looked);
  ASSERT_EQ(desk().frame->boids.size(), 40u);
  EXPECT_EQ(desk().files.watched(), "world.toml");
  write("other.toml", with(small_world, "weight = 0.01", "weight = 0.25"));
  frames(until_looked);
  EXPECT_EQ(scenario().flocks[0].cohesion[0].weight, 0.01) << "the other file changed";
  write("world.toml", with(small_world, "weight = 0.01", "weight = 0.5"));
  frames(until_looked);
  EXPECT_EQ(scenario().flocks[0].cohesion[0].weight, 0.5);
  press(SDLK_z, KMOD_LCTRL);
  EXPECT_EQ(scenario().flocks[0].cohesion[0].weight, 0.01);
}

TEST_F(StudioFiles, AFileWithEventsThatDidNotChangeBeginsNothingAnew) {
  const std::string text = std::string("[run]\nevents = [[5, \"erase\", [200, 150], 30]]\n");
  write("world.toml", with(small_world, "[space]", text + "[space]"));
  open("world.toml", 0);
  frames(60);
  const std::uint64_t generation = desk().frame->generation;
  write("world.toml", with(read("world.toml"), "weight = 0.01", "weight = 0.5"));
  frames(until_looked);
  EXPECT_EQ(scenario().flocks[0].cohesion[0].weight, 0.5);
  EXPECT_EQ(desk().frame->generation, generation);
}

TEST_F(StudioFiles, TheClipboardCarriesAScenarioThereAndBack) {
  open("ucsd");
  desk().set("flock.birds.cohesion.weight", "0.125");
  frames(2);
  press(SDLK_c, KMOD_LCTRL);
  char* held = SDL_GetClipboardText();
  const auto copied = sturnus::parse_scenario(held, "clipboard");
  SDL_free(held);
  ASSERT_TRUE(copied) << copied.error();
  EXPECT_EQ(to_toml(*copied), to_toml(scenario()));
  SDL_SetClipboardText(with(small_world, "count = 40", "count = 33").c_str());
  press(SDLK_v, KMOD_LCTRL);
  EXPECT_EQ(desk().frame->boids.size(), 33u);
  SDL_SetClipboardText("boids = many\n");
  press(SDLK_v, KMOD_LCTRL);
  EXPECT_SAYS(said(), "clipboard:1");
  EXPECT_EQ(desk().frame->boids.size(), 33u);
}

TEST_F(StudioFiles, DroppedFilesAreOpenedByTheirKind) {
  open("ucsd");
  write("world.toml", small_world);
  write("state.csv", "id,flock,x,y,vx,vy\n0,0,10,20,5,0\n1,0,30,40,0,5\n2,0,50,60,5,5\n");
  write("notes.txt", "hello");
  drop(path("world.toml"));
  EXPECT_EQ(desk().frame->boids.size(), 40u);
  EXPECT_EQ(desk().files.watched(), path("world.toml"));
  desk().playback.play(false);
  desk().session.act(sturnus::PlaceObstacle{{300, 200}, 15}, "obstacle");
  drop(path("state.csv"));
  EXPECT_EQ(desk().frame->boids.size(), 3u);
  EXPECT_EQ(desk().frame->obstacles.size(), 1u) << "what was placed belongs to the scenario";
  EXPECT_EQ(desk().files.watched(), path("world.toml"));
  EXPECT_EQ(scenario().flocks[0].name, "birds");
  drop(path("notes.txt"));
  EXPECT_SAYS(said(), "notes.txt: only scenarios");
  EXPECT_EQ(desk().frame->boids.size(), 3u);
}

#ifdef STURNUS_PROGRAM
TEST_F(StudioFiles, ASavedSessionReplaysToTheSameHash) {
  open("ucsd");
  desk().session.act(sturnus::AddBoids{"birds", 8, {100, 100}, 5}, "add units");
  frames(30);
  desk().set("flock.birds.cohesion.weight", "0.125");
  desk().session.act(sturnus::ScatterBoids{{200, 200}, 150}, "scatter");
  frames(45);
  desk().playback.play(false);
  frames(3);
  const std::uint64_t end = hash(), step = desk().frame->step;
  desk().files.save_session(desk(), "visit");
  frames(2);
  EXPECT_SAYS(said(), "visit.toml");
  char expected[32];
  std::snprintf(expected, sizeof expected, "%016llx", static_cast<unsigned long long>(end));
  const std::string told =
      output_of(STURNUS_PROGRAM " run visit.toml --steps " + std::to_string(step) + " 2>&1");
  EXPECT_SAYS(told, expected);
}
#endif

TEST_F(StudioFiles, NothingIsOverwritten) {
  open("ucsd");
  desk().playback.play(false);
  frames(3);
  desk().files.save_scenario(desk(), "mine");
  desk().files.save_scenario(desk(), "mine");
  desk().files.save_state(desk(), "");
  frames(2);
  EXPECT_EQ(read("mine.toml"), read("mine-2.toml"));
  const auto again = sturnus::load_scenario("mine.toml");
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(to_toml(*again), to_toml(scenario()));
  const std::string csv = "ucsd-" + std::to_string(desk().frame->step) + ".csv";
  const auto state = sturnus::read_state_csv(csv);
  ASSERT_TRUE(state) << state.error();
  EXPECT_EQ(state->size(), 50u);
}

class StudioRecent : public InFolder {};

TEST_F(StudioRecent, NewestFirstWithoutThoseThatAreGone) {
  const std::string list = recent_list_path();
  EXPECT_EQ(list, path("state/sturnus/recent.txt"));
  EXPECT_TRUE(recent_files(list).empty());
  for (const char* name : {"a.toml", "b.toml", "c.toml"}) {
    write(name, small_world);
    remember_file(list, name);
  }
  remember_file(list, "a.toml");
  std::filesystem::remove("b.toml");
  const std::vector<std::string> expected = {path("a.toml"), path("c.toml")};
  EXPECT_EQ(recent_files(list), expected);
}

TEST_F(StudioRecent, APlaceThatCantBeWrittenIsNoError) {
  write("file", "");
  remember_file(path("file/recent.txt"), "a.toml");
  EXPECT_TRUE(recent_files(path("file/recent.txt")).empty());
}

}  // namespace
}  // namespace studio
